// SPDX-License-Identifier: MIT
#include "experiments/drawing/sphere_image.hpp"

#include <cmath>
#include <utility>

namespace impetus::inline drawing {
namespace {

/// The two tangents from the eye in the plane of one screen direction and the line of sight.
std::pair<double, double> tangents(double across_m, double ahead_m, double radius_m) {
  const double direction = std::atan2(across_m, ahead_m);
  const double half_angle = std::asin(radius_m / std::hypot(across_m, ahead_m));
  return {std::tan(direction - half_angle), std::tan(direction + half_angle)};
}

}  // namespace

Vector3 seen_from_eye(const Viewer& viewer, const Vector3& p_WP) {
  const Vector3 from_eye = p_WP - viewer.eye;
  const Vector3 towards = viewer.right.cross(viewer.up);
  return {viewer.right.dot(from_eye), viewer.up.dot(from_eye), towards.dot(from_eye)};
}

std::optional<ImageBounds> image_of_sphere(const Vector3& p_EC, double radius_m,
                                           double distance_m) {
  const double ahead_m = -p_EC.z();
  if (ahead_m <= radius_m) {
    return std::nullopt;
  }
  const auto [left, right] = tangents(p_EC.x(), ahead_m, radius_m);
  const auto [bottom, top] = tangents(p_EC.y(), ahead_m, radius_m);
  return ImageBounds{left * distance_m, right * distance_m, bottom * distance_m, top * distance_m};
}

}  // namespace impetus::inline drawing
