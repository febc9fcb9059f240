// A mesh of rings one after the other, the last joined to the first.
//
//   ring i     j --- j+1        Corners run counter-clockwise as seen from ahead,
//              |  \   |         the way in which the rings follow one another.
//   ring i+1   j --- j+1
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 2 · rings · sides outward triangles over `vertices`, `sides` of them for each ring in turn.
/// Preconditions: sides ≥ 3, at least three rings, no ring left over.
TriangleMesh closed_tube(std::vector<Vector3> vertices, int sides);

}  // namespace impetus::inline shapes
