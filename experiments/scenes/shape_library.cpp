// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_library.hpp"

#include <algorithm>
#include <utility>

#include "engine/shapes/box_mesh.hpp"
#include "engine/shapes/creature_mesh.hpp"
#include "engine/shapes/knot_mesh.hpp"
#include "engine/shapes/l_block_mesh.hpp"
#include "engine/shapes/torus_mesh.hpp"
#include "engine/trees/octree.hpp"

namespace impetus {
namespace {

using nlohmann::json;

BodyShape sphere_shape(double radius_m) {
  const VolumeTree tree = single_node_tree(Sphere{Vector3::Zero(), radius_m});
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

/// The mesh of any kind but a sphere. Resolution counts the sides of a torus' or a knot's tube and
/// a quarter of the cells along a creature's length.
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

BodyShape build(const json& description, double metres_per_degree, int tree_depth) {
  if (description["kind"].get<std::string>() == "sphere") {
    return sphere_shape(description["radius_deg"].get<double>() * metres_per_degree);
  }
  return mesh_shape(mesh_of(description, metres_per_degree), tree_depth);
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
