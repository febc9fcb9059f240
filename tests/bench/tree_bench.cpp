// Volume trees of all kinds: how tight, how large, how long to build, beside the best known
// figures.
//
//   impetus_tree_bench [MESH]...        the project's own shapes, then the mesh files named
//
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/level_quality.hpp"
#include "experiments/files/mesh_file.hpp"
#include "experiments/models/named_shape.hpp"

namespace impetus {
namespace {

/// Figures of public builders, taken on a machine of the kind this was written on: for a cow of
/// 5,856 triangles the best medial builder (349 s, 1.62 % of the surface uncovered) and its octree
/// (0.23 s), branching 8. Worst protrusion in % of the diagonal, outside volume over the mesh's.
constexpr const char* kAnchors =
    "anchors, a cow of 5,856 triangles:\n"
    "  best public medial builder  32.5 9.0 2.85 1.19 %   outside 5.5 .93 .19 .055   349 s\n"
    "  its octree                  33 48 24 13 %                                     0.23 s\n"
    "  goal                        no worse, nothing uncovered, 5 s; 60,000 triangles 60 s\n"
    "anchors, a dragon of 2,000 triangles, about 500 leaves, in bounding radii:\n"
    "  mean .0137, worst .061, 98.3 % covered, 141 s; goal .014, .061, all covered, 3 s\n";

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Extent {
  double diagonal_m;
  double radius_m;  ///< about the centre of mass
};

Extent extent_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  double radius_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
    radius_m = std::max(radius_m, vertex.norm());
  }
  return {bounds.diagonal().norm(), radius_m};
}

void print_tree(const TriangleMesh& mesh, const std::string& kind) {
  const double before_s = cpu_s();
  const VolumeTree tree = build_tree(mesh, {tree_kind(kind), /*depth=*/3, /*branching=*/8});
  const double built_s = cpu_s() - before_s;
  const auto [diagonal_m, radius_m] = extent_of(mesh);
  std::string worst;
  std::string outside;
  double uncovered_m2 = 0.0;
  const std::vector<LevelQuality> levels = measure_levels(mesh, tree);
  for (const LevelQuality& level : levels) {
    char text[32];
    std::snprintf(text, sizeof text, "%6.2f", 100.0 * level.worst_protrusion_m / diagonal_m);
    worst += text;
    std::snprintf(text, sizeof text, "%7.3f", level.outside_ratio);
    outside += text;
    uncovered_m2 += level.uncovered_area_m2;
  }
  std::printf("%-14s %5d nodes %5.1f B/node %6.2f s  worst %-24s %%  outside %-28s", kind.c_str(),
              tree.node_count(), static_cast<double>(tree.bytes()) / tree.node_count(), built_s,
              worst.c_str(), outside.c_str());
  std::printf(
      "  finest, in radii: mean %.4f worst %.4f  %s\n", levels.back().mean_protrusion_m / radius_m,
      levels.back().worst_protrusion_m / radius_m, uncovered_m2 == 0.0 ? "covered" : "NOT COVERED");
}

void print_trees(const std::string& name, const TriangleMesh& solid) {
  const TriangleMesh mesh = about_centre_of_mass(solid);
  std::printf("\n%s, %zu triangles (CPU seconds; worst: certified bound, %% of the diagonal)\n",
              name.c_str(), mesh.triangles.size());
  for (const std::string& kind : tree_kind_names()) {
    print_tree(mesh, kind);
  }
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    std::printf("%s", impetus::kAnchors);
    for (const std::string& shape : impetus::shape_names()) {
      impetus::print_trees(shape, impetus::shape_named(shape));
    }
    impetus::print_trees("creature of resolution 8", impetus::shape_named("creature", 8));
    for (int i = 1; i < count; ++i) {
      impetus::print_trees(arguments[i], impetus::load_mesh(arguments[i]));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
