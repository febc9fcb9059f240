// SPDX-License-Identifier: MIT
#include "engine/trees/tree_settings.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/shapes/mass_properties.hpp"

namespace impetus::inline trees {
namespace {

bool is_cube_number(int count) {
  int root = 1;
  while (root * root * root < count) {
    ++root;
  }
  return root * root * root == count;
}

/// The levels below the root that leave at most 1625 cells along an edge: 1625³ < 2³² ≤ 1626³.
int greatest_voxel_depth(int branching) {
  const int along = branching == 8 ? 2 : branching == 27 ? 3 : 4;
  int depth = 0;
  for (int cells = along; cells <= 1625 && depth < kGreatestTreeDepth; cells *= along) {
    ++depth;
  }
  return depth;
}

std::string range(const std::string& what, int least, int most, int got) {
  return "tree: expected a " + what + " from " + std::to_string(least) + " to " +
         std::to_string(most) + ", got " + std::to_string(got);
}

constexpr double kLeastShare = 1e-12;

}  // namespace

int levels_to_build(const TreeSettings& settings) {
  return std::min(settings.depth, settings.built_depth);
}

const std::vector<std::string>& tree_kind_names() {
  static const std::vector<std::string> kNames{"octree", "medial", "voxel",
                                               "box",    "swept",  "heterogeneous"};
  return kNames;
}

std::string name_of(TreeKind kind) { return tree_kind_names()[static_cast<std::size_t>(kind)]; }

TreeKind tree_kind(const std::string& name) {
  const std::vector<std::string>& names = tree_kind_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string message = "tree: expected a kind among";
    for (const std::string& known : names) {
      message += (known == names.front() ? " " : ", ") + known;
    }
    throw std::invalid_argument(message + ", got \"" + name + "\"");
  }
  return static_cast<TreeKind>(found - names.begin());
}

std::string problem_of(const TreeSettings& settings) {
  const int branching = settings.branching;
  if (settings.depth < 0 || settings.depth > kGreatestTreeDepth) {
    return range("depth", 0, kGreatestTreeDepth, settings.depth);
  }
  if (settings.built_depth < 0 || settings.built_depth > kGreatestTreeDepth) {
    return range("depth to build", 0, kGreatestTreeDepth, settings.built_depth);
  }
  if (branching < kLeastBranching || branching > kGreatestBranching) {
    return range("branching", kLeastBranching, kGreatestBranching, branching);
  }
  if (settings.kind == TreeKind::kOctree && branching != 8) {
    return "tree: expected a branching of 8 for an octree, got " + std::to_string(branching);
  }
  if (settings.kind == TreeKind::kVoxel && !is_cube_number(branching)) {
    return "tree: expected a branching of 8, 27 or 64 for voxels, got " + std::to_string(branching);
  }
  if (settings.kind == TreeKind::kVoxel && settings.depth > greatest_voxel_depth(branching)) {
    return "tree: expected a depth from 0 to " + std::to_string(greatest_voxel_depth(branching)) +
           " for voxels of branching " + std::to_string(branching) + ", got " +
           std::to_string(settings.depth);
  }
  return {};
}

void require_buildable(const TriangleMesh& mesh, const TreeSettings& settings) {
  const std::string problem = problem_of(settings);
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  require_solid(mesh, "tree");
}

void require_solid(const TriangleMesh& mesh, const std::string& builder) {
  if (mesh.triangles.empty() || !find_defects(mesh).none()) {
    throw std::invalid_argument(builder +
                                ": expected a closed mesh with its triangles facing outward");
  }
  const double volume_m3 = solid_of(mesh, /*density_kg_m3=*/1.0).volume_m3;
  const double side_m = bounds_of(mesh).sides().maxCoeff();
  if (!(volume_m3 > 0.0)) {
    throw std::invalid_argument(builder +
                                ": expected a closed mesh with its triangles facing outward");
  }
  if (volume_m3 / side_m / side_m / side_m < kLeastShare) {
    throw std::invalid_argument(builder +
                                ": expected a solid, got a mesh that encloses next to nothing");
  }
}

}  // namespace impetus::inline trees
