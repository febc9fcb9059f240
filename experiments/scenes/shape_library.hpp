// The shapes that scenes name, built once each: mesh, mass and volume tree.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus {

/// A shape in the frame of its centre of mass.
struct BodyShape {
  std::shared_ptr<const TriangleMesh> mesh;  ///< none: a sphere of `radius_m`
  std::shared_ptr<const VolumeTree> tree;
  MassProperties unit_mass;  ///< at a density of 1 kg/m³
  double radius_m{0.0};      ///< of a ball about the centre of mass that holds the shape
};

class ShapeLibrary {
 public:
  /// The shape of a scene's body. `description` is valid by the scene's schema and checks.
  const BodyShape& shape(const nlohmann::json& description, double metres_per_degree,
                         int tree_depth);

 private:
  /// Description, metres per degree, depth of the tree.
  using Key = std::tuple<std::string, double, int>;
  std::map<Key, BodyShape> shapes_;
};

}  // namespace impetus
