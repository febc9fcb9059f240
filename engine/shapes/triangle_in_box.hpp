// Whether a triangle reaches into a box.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline shapes {

/// Whether the triangle meets the box |x_i| ≤ half_extents_m[i], by the thirteen separating axes
/// (Akenine-Möller 2001): false is certain up to rounding, true where they touch.
bool meets_box(const Triangle& triangle, const Vector3& half_extents_m);

}  // namespace impetus::inline shapes
