// SPDX-License-Identifier: MIT
#include "engine/volumes/swept.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace impetus::inline volumes {
namespace {

constexpr double kPi = std::numbers::pi;

double square(double x) { return x * x; }

/// The share of `half` along which `offset` lies, kept within ±1; 0 for a `half` of no length.
double share_along(const Vector3& half, const Vector3& offset) {
  const double length_squared = half.squaredNorm();
  return length_squared > 0.0 ? std::clamp(offset.dot(half) / length_squared, -1.0, 1.0) : 0.0;
}

}  // namespace

Sphere bounding_sphere(const LineSwept& line) {
  return {line.centre, line.half_axis.norm() + line.radius_m};
}

CoredVolume cored(const LineSwept& line) {
  return {rectangle_core(line.centre, line.half_axis, Vector3::Zero()), line.radius_m};
}

LineSwept placed(const LineSwept& line, const Pose& pose) {
  return {pose.transform(line.centre), pose.orientation * line.half_axis, line.radius_m};
}

bool holds(const LineSwept& line, const Vector3& point) {
  const Vector3 offset = point - line.centre;
  return (offset - share_along(line.half_axis, offset) * line.half_axis).squaredNorm() <=
         square(line.radius_m);
}

double content_m3(const LineSwept& line) {
  return content_m3(Sphere{line.centre, line.radius_m}) +
         2.0 * line.half_axis.norm() * kPi * square(line.radius_m);
}

Sphere bounding_sphere(const RectangleSwept& rectangle) {
  const double half_diagonal =
      std::sqrt(rectangle.half_u.squaredNorm() + rectangle.half_v.squaredNorm());
  return {rectangle.centre, half_diagonal + rectangle.radius_m};
}

CoredVolume cored(const RectangleSwept& rectangle) {
  return {rectangle_core(rectangle.centre, rectangle.half_u, rectangle.half_v), rectangle.radius_m};
}

RectangleSwept placed(const RectangleSwept& rectangle, const Pose& pose) {
  return {pose.transform(rectangle.centre), pose.orientation * rectangle.half_u,
          pose.orientation * rectangle.half_v, rectangle.radius_m};
}

bool holds(const RectangleSwept& rectangle, const Vector3& point) {
  const Vector3 offset = point - rectangle.centre;
  const Vector3 nearest = share_along(rectangle.half_u, offset) * rectangle.half_u +
                          share_along(rectangle.half_v, offset) * rectangle.half_v;
  return (offset - nearest).squaredNorm() <= square(rectangle.radius_m);
}

double content_m3(const RectangleSwept& rectangle) {
  const double u_m = 2.0 * rectangle.half_u.norm();
  const double v_m = 2.0 * rectangle.half_v.norm();
  return content_m3(Sphere{rectangle.centre, rectangle.radius_m}) +
         (u_m + v_m) * kPi * square(rectangle.radius_m) + 2.0 * u_m * v_m * rectangle.radius_m;
}

}  // namespace impetus::inline volumes
