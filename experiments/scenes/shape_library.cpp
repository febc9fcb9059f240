// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_library.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/builders/swept_tree.hpp"
#include "experiments/scenes/coarser_meshes.hpp"
#include "experiments/scenes/scene_meshes.hpp"
#include "experiments/scenes/swept_shape.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

BodyShape sphere_shape(double radius_m) {
  const VolumeTree tree = single_node_tree(Sphere{Vector3::Zero(), radius_m});
  return {nullptr, std::make_shared<const VolumeTree>(tree), solid_sphere(radius_m, 1.0), radius_m};
}

/// Of a mesh about its centre of mass.
BodyShape shape_of_mesh(const TriangleMesh& mesh, VolumeTree tree) {
  double radius_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    radius_m = std::max(radius_m, vertex.norm());
  }
  return {std::make_shared<const TriangleMesh>(mesh),
          std::make_shared<const VolumeTree>(std::move(tree)), solid_of(mesh, 1.0), radius_m};
}

/// A tree that takes less time to build than to fetch is not worth a file.
bool builds_at_once(const TriangleMesh& mesh, const TreeSettings& tree) {
  constexpr std::size_t kFewTriangles = 2000;
  return tree.kind == TreeKind::kOctree && mesh.triangles.size() < kFewTriangles;
}

/// The mesh of any kind but a sphere, a swept volume or a file. Resolution counts the sides of a
/// torus' or a knot's tube and a quarter of the cells along a creature's length.
TriangleMesh mesh_of(const json& shape, double metres_per_degree) {
  const auto length_m = [&](const char* key) {
    return shape[key].get<double>() * metres_per_degree;
  };
  const auto resolution = [&](int usual) { return shape.value("resolution", usual); };
  const auto kind = shape["kind"].get<std::string>();
  if (kind == "box") {
    return box_mesh({length_m("width_deg"), length_m("height_deg"), length_m("depth_deg")});
  }
  if (kind == "plate") {
    return box_mesh({length_m("width_deg"), length_m("height_deg"), length_m("thickness_deg")});
  }
  if (kind == "torus") {
    const int sides = resolution(10);
    return torus_mesh(length_m("radius_deg"), length_m("tube_deg"), 3 * sides, sides);
  }
  if (kind == "knot") {
    const int sides = resolution(8);
    return knot_mesh(length_m("radius_deg"), length_m("tube_deg"), 8 * sides, sides);
  }
  if (kind == "creature") {
    return creature_mesh(length_m("length_deg"), 4 * resolution(4));
  }
  return l_block_mesh(length_m("arm_deg"), length_m("thickness_deg"));
}

/// The mesh with its longest side as long as `size_m`.
TriangleMesh scaled_to(double size_m, TriangleMesh mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
  }
  const double scale = size_m / bounds.sizes().maxCoeff();
  for (Vector3& vertex : mesh.vertices) {
    vertex *= scale;
  }
  return mesh;
}

}  // namespace

VolumeTree ShapeLibrary::tree_of(const TriangleMesh& mesh, const TreeSettings& tree) const {
  return builds_at_once(mesh, tree) ? build_tree(mesh, tree) : cache_.tree(mesh, tree, progress_);
}

BodyShape ShapeLibrary::mesh_shape(const TriangleMesh& solid, const TreeSettings& tree) const {
  const TriangleMesh mesh = about_centre_of_mass(solid);
  return shape_of_mesh(mesh, tree_of(mesh, tree));
}

BodyShape ShapeLibrary::swept_body(const json& description, const ShapeFrame& frame) const {
  const SweptShape swept = swept_shape(description, frame.metres_per_degree);
  const TriangleMesh mesh = about_centre_of_mass(swept.mesh);
  std::optional<VolumeTree> finer;
  if (const auto settings = finer_settings(swept.levels, frame.tree)) {
    finer = tree_of(mesh, *settings);
  }
  return shape_of_mesh(
      mesh, swept_tree(mesh, swept.volume, swept.levels, frame.tree, finer ? &*finer : nullptr));
}

BodyShape ShapeLibrary::built(const json& description, const json& meshes,
                              const ShapeFrame& frame) const {
  if (is_mesh(description)) {
    const double size_m = description["size_deg"].get<double>() * frame.metres_per_degree;
    const auto file = description["file"].get<std::string>();
    return mesh_shape(scaled_to(size_m, mesh_content(meshes, file)), frame.tree);
  }
  if (description["kind"].get<std::string>() == "sphere") {
    return sphere_shape(description["radius_deg"].get<double>() * frame.metres_per_degree);
  }
  if (is_swept(description)) {
    return swept_body(description, frame);
  }
  return mesh_shape(mesh_of(description, frame.metres_per_degree), frame.tree);
}

const BodyShape& ShapeLibrary::shape(const json& description, const json& meshes,
                                     const ShapeFrame& frame) {
  std::string what = description.dump();
  if (is_mesh(description)) {
    what += meshes[description["file"].get<std::string>()]["hash"].get<std::string>();
  }
  const Key key{what,
                frame.metres_per_degree,
                frame.tree.kind,
                frame.tree.depth,
                frame.tree.branching,
                frame.tree.built_depth};
  const std::lock_guard lock(building_);
  const auto known = shapes_.find(key);
  if (known == shapes_.end()) {
    shapes_[key] = built(description, meshes, frame);
  }
  return shapes_[key];
}

std::shared_ptr<const DrawnLevels> ShapeLibrary::coarser(
    const std::shared_ptr<const TriangleMesh>& mesh) {
  const std::lock_guard lock(building_);
  std::shared_ptr<const DrawnLevels>& known = coarser_[mesh];
  if (!known) {
    known = std::make_shared<const DrawnLevels>(coarser_meshes(*mesh, progress_));
  }
  return known;
}

}  // namespace impetus::inline scenes
