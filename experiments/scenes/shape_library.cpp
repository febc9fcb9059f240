// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_library.hpp"

#include <algorithm>
#include <utility>

#include "engine/shapes/box_mesh.hpp"
#include "engine/shapes/l_block_mesh.hpp"
#include "engine/trees/octree.hpp"

namespace impetus {
namespace {

using nlohmann::json;

BodyShape sphere_shape(double radius_m) {
  const VolumeTree tree = single_node_tree({Vector3::Zero(), radius_m});
  return {nullptr, std::make_shared<const VolumeTree>(tree), solid_sphere(radius_m, 1.0), radius_m};
}

BodyShape mesh_shape(const TriangleMesh& solid, int tree_depth) {
  const TriangleMesh mesh = about_centre_of_mass(solid);
  double radius_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    radius_m = std::max(radius_m, vertex.norm());
  }
  return {std::make_shared<const TriangleMesh>(mesh),
          std::make_shared<const VolumeTree>(octree(mesh, tree_depth)), solid_of(mesh, 1.0),
          radius_m};
}

BodyShape build(const json& description, double metres_per_degree, int tree_depth) {
  const auto length_m = [&](const char* key) {
    return description[key].get<double>() * metres_per_degree;
  };
  const auto kind = description["kind"].get<std::string>();
  if (kind == "sphere") {
    return sphere_shape(length_m("radius_deg"));
  }
  if (kind == "box") {
    const Vector3 sides(length_m("width_deg"), length_m("height_deg"), length_m("depth_deg"));
    return mesh_shape(box_mesh(sides), tree_depth);
  }
  return mesh_shape(l_block_mesh(length_m("arm_deg"), length_m("thickness_deg")), tree_depth);
}

}  // namespace

const BodyShape& ShapeLibrary::shape(const json& description, double metres_per_degree,
                                     int tree_depth) {
  const Key key{description.dump(), metres_per_degree, tree_depth};
  const auto known = shapes_.find(key);
  if (known == shapes_.end()) {
    shapes_[key] = build(description, metres_per_degree, tree_depth);
  }
  return shapes_[key];
}

}  // namespace impetus
