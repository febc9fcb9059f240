// Whether a point lies inside the solid that a closed mesh bounds, and how far from its surface.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// By the winding number, the sum of the triangles' solid angles over 4π (Van Oosterom and Strackee
/// 1983). Points of the surface itself may fall either way.
bool contains(const TriangleMesh& solid, const Vector3& point);

/// Distance from `point` to the nearest triangle (metres).
double distance_to_surface(const TriangleMesh& mesh, const Vector3& point);

}  // namespace impetus::inline shapes
