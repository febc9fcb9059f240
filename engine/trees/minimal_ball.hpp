// The smallest ball round points.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {

/// The smallest sphere that holds `points` (one or more), but for rounding of 1e-12 of its radius:
/// the farthest point joins at most four that hold the ball up, and the smallest ball of these five
/// is taken, until none is outside. (after Gärtner 1999)
Sphere minimal_ball(const std::vector<Vector3>& points);

}  // namespace impetus::inline trees
