// Where a sphere's image lies on the glass.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline drawing {

/// A point as the viewer sees it: right, up, and towards the viewer, from the eye (metres).
Vector3 seen_from_eye(const Viewer& viewer, const Vector3& p_WP);

/// Bounds on the glass, metres from its centre.
struct ImageBounds {
  double left{0.0};
  double right{0.0};
  double bottom{0.0};
  double top{0.0};
};

/// Exact bounds of the perspective image of a sphere with its centre at `p_EC` (as seen from the
/// eye) on a glass `distance_m` away; nothing when it reaches the eye's own plane.
std::optional<ImageBounds> image_of_sphere(const Vector3& p_EC, double radius_m, double distance_m);

}  // namespace impetus::inline drawing
