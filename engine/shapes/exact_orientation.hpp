// On which side of a line or a plane a point lies, without rounding.
//
//   determinant in doubles --beyond its error bound--> sign
//                          --within it--> the same determinant as an exact sum --> sign
//
// (Shewchuk 1997: the bound of his orient3d, grow-expansion and two-product)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/vector.hpp"

namespace impetus::inline shapes {

/// The sign of (b - a) × (c - a) · (d - a): +1 when `d` is where `a`, `b`, `c` run
/// counter-clockwise, 0 when all four lie in one plane. Coordinates (metres) must be finite and,
/// but for zero, their products of three neither overflow nor underflow.
int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/// The same in the plane that is left when coordinate `axis` (0, 1, 2) is dropped: +1 when `a`,
/// `b`, `c` run counter-clockwise as seen from the positive end of that axis, 0 when they are in
/// line.
int turn_across(int axis, const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace impetus::inline shapes
