// SPDX-License-Identifier: MIT
#include "engine/volumes/enclosure.hpp"

#include <algorithm>

namespace impetus::inline volumes {
WallReach::WallReach(const Enclosure& walls) : cube_(std::get_if<ClosedCube>(&walls)) {
  if (cube_ != nullptr) {
    return;
  }
  const auto& frustum = std::get<ViewFrustum>(walls);
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 outward = -inward_normal(frustum, wall);
    const double offset_m = wall == 4   ? frustum.front_m
                            : wall == 5 ? frustum.back_m
                                        : outward.dot(frustum.eye);
    planes_[static_cast<std::size_t>(wall)] = {outward, offset_m};
  }
}

bool WallReach::operator()(const Sphere& sphere) const {
  if (cube_ != nullptr) {
    return reaches_wall(*cube_, sphere);
  }
  return std::any_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    return plane.outward.dot(sphere.centre) - plane.offset_m + sphere.radius_m >= 0.0;
  });
}

}  // namespace impetus::inline volumes
