// SPDX-License-Identifier: MIT
#include "engine/volumes/volume.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace impetus {
namespace {

constexpr double kPi = std::numbers::pi;

double square(double x) { return x * x; }

/// The share of `half` along which `offset` lies, kept within ±1; 0 for a `half` of no length.
double share_along(const Vector3& half, const Vector3& offset) {
  const double length_squared = half.squaredNorm();
  return length_squared > 0.0 ? std::clamp(offset.dot(half) / length_squared, -1.0, 1.0) : 0.0;
}

Sphere bound_of(const Sphere& sphere) { return sphere; }
Sphere bound_of(const LineSwept& line) {
  return {line.centre, line.half_axis.norm() + line.radius_m};
}
Sphere bound_of(const RectangleSwept& rectangle) {
  const double half_diagonal =
      std::sqrt(rectangle.half_u.squaredNorm() + rectangle.half_v.squaredNorm());
  return {rectangle.centre, half_diagonal + rectangle.radius_m};
}
Sphere bound_of(const Box& box) { return {box.centre, box.half_extents_m.norm()}; }
Sphere bound_of(const Cube& cube) { return {cube.centre, std::sqrt(3.0) * cube.half_edge_m}; }

bool holds_point(const Sphere& sphere, const Vector3& point) {
  return (point - sphere.centre).squaredNorm() <= square(sphere.radius_m);
}
bool holds_point(const LineSwept& line, const Vector3& point) {
  const Vector3 offset = point - line.centre;
  return (offset - share_along(line.half_axis, offset) * line.half_axis).squaredNorm() <=
         square(line.radius_m);
}
bool holds_point(const RectangleSwept& rectangle, const Vector3& point) {
  const Vector3 offset = point - rectangle.centre;
  const Vector3 nearest = share_along(rectangle.half_u, offset) * rectangle.half_u +
                          share_along(rectangle.half_v, offset) * rectangle.half_v;
  return (offset - nearest).squaredNorm() <= square(rectangle.radius_m);
}
bool holds_point(const Box& box, const Vector3& point) {
  const Vector3 within = box.orientation.conjugate() * (point - box.centre);
  return (within.cwiseAbs().array() <= box.half_extents_m.array()).all();
}
bool holds_point(const Cube& cube, const Vector3& point) {
  const Vector3 within = cube.orientation.conjugate() * (point - cube.centre);
  return within.cwiseAbs().maxCoeff() <= cube.half_edge_m;
}

double content_of(const Sphere& sphere) {
  return 4.0 / 3.0 * kPi * sphere.radius_m * square(sphere.radius_m);
}
double content_of(const LineSwept& line) {
  return content_of(Sphere{line.centre, line.radius_m}) +
         2.0 * line.half_axis.norm() * kPi * square(line.radius_m);
}
double content_of(const RectangleSwept& rectangle) {
  const double u_m = 2.0 * rectangle.half_u.norm();
  const double v_m = 2.0 * rectangle.half_v.norm();
  return content_of(Sphere{rectangle.centre, rectangle.radius_m}) +
         (u_m + v_m) * kPi * square(rectangle.radius_m) + 2.0 * u_m * v_m * rectangle.radius_m;
}
double content_of(const Box& box) { return 8.0 * box.half_extents_m.prod(); }
double content_of(const Cube& cube) { return 8.0 * cube.half_edge_m * square(cube.half_edge_m); }

}  // namespace

Sphere bounding_sphere(const Volume& volume) {
  return std::visit([](const auto& kind) { return bound_of(kind); }, volume);
}

bool holds(const Volume& volume, const Vector3& point) {
  return std::visit([&](const auto& kind) { return holds_point(kind, point); }, volume);
}

double content_m3(const Volume& volume) {
  return std::visit([](const auto& kind) { return content_of(kind); }, volume);
}

}  // namespace impetus
