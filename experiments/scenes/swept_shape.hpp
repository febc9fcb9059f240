// Shapes that are a sphere swept along a line or a rectangle: the limbs and trunks of figures.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/builders/swept_tree.hpp"

namespace impetus::inline scenes {

/// Whether the shape is of kind line-swept or rectangle-swept.
bool is_swept(const nlohmann::json& shape);

/// The volume about the origin, the mesh inscribed in it, and the levels that its tree is to have.
struct SweptShape {
  TriangleMesh mesh;
  Volume volume;
  SweptLevels levels;
};

/// Precondition: is_swept(shape), and add_shape_problems() adds none.
SweptShape swept_shape(const nlohmann::json& shape, double metres_per_degree);

}  // namespace impetus::inline scenes
