// SPDX-License-Identifier: MIT
#include "engine/scheduling/seen_motion.hpp"

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scheduling {

Vector3 seen_velocity(const Viewer& viewer, const Vector3& place, const Vector3& velocity) {
  const Vector3 from_eye = place - viewer.eye;
  return velocity - viewer.velocity - viewer.turning.cross(from_eye);
}

double angular_speed_deg_s(const Viewer& viewer, const Vector3& place, const Vector3& velocity) {
  const Vector3 from_eye = place - viewer.eye;
  const Vector3 seen = seen_velocity(viewer, place, velocity);
  return degrees(from_eye.cross(seen).norm() / from_eye.squaredNorm());
}

std::optional<ScreenVelocity> projected_velocity(const Viewer& viewer, const Vector3& place,
                                                 const Vector3& velocity) {
  const double to_screen_m = viewer.eye.norm();
  const Vector3 forward = -viewer.eye / to_screen_m;
  const Vector3 from_eye = place - viewer.eye;
  const double depth_m = from_eye.dot(forward);
  if (depth_m <= 0.0) {
    return std::nullopt;
  }
  const Vector3 seen = seen_velocity(viewer, place, velocity);
  const auto along = [&](const Vector3& axis) {
    return to_screen_m * (seen.dot(axis) * depth_m - from_eye.dot(axis) * seen.dot(forward)) /
           (depth_m * depth_m);
  };
  return ScreenVelocity{along(viewer.right), along(viewer.up)};
}

}  // namespace impetus::inline scheduling
