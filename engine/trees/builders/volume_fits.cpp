// SPDX-License-Identifier: MIT
#include "engine/trees/builders/volume_fits.hpp"

#include <algorithm>

namespace impetus::inline trees {
namespace {

double square(double x) { return x * x; }

double share_along(const Vector3& half, const Vector3& offset) {
  const double length_squared = half.squaredNorm();
  return length_squared > 0.0 ? std::clamp(offset.dot(half) / length_squared, -1.0, 1.0) : 0.0;
}

double distance_to_core(const Sphere& sphere, const Vector3& point) {
  return (point - sphere.centre).norm();
}

double distance_to_core(const LineSwept& line, const Vector3& point) {
  const Vector3 offset = point - line.centre;
  return (offset - share_along(line.half_axis, offset) * line.half_axis).norm();
}

double distance_to_core(const RectangleSwept& rectangle, const Vector3& point) {
  const Vector3 offset = point - rectangle.centre;
  return (offset - share_along(rectangle.half_u, offset) * rectangle.half_u -
          share_along(rectangle.half_v, offset) * rectangle.half_v)
      .norm();
}

template <typename Swept>
void refit(Swept& swept, const std::vector<Vector3>& corners) {
  swept.radius_m = 0.0;
  for (const Vector3& corner : corners) {
    swept.radius_m = std::max(swept.radius_m, distance_to_core(swept, corner));
  }
}

void refit(Box& box, const std::vector<Vector3>& corners) {
  const Quaternion to_box = box.orientation.conjugate();
  Vector3 least = to_box * (corners.front() - box.centre);
  Vector3 most = least;
  for (const Vector3& corner : corners) {
    const Vector3 within = to_box * (corner - box.centre);
    least = least.cwiseMin(within);
    most = most.cwiseMax(within);
  }
  box.centre += box.orientation * (0.5 * (least + most));
  box.half_extents_m = 0.5 * (most - least);
}

void refit(Cube& cube, const std::vector<Vector3>& corners) {
  cube.half_edge_m = 0.0;
  for (const Vector3& corner : corners) {
    const Vector3 within = cube.orientation.conjugate() * (corner - cube.centre);
    cube.half_edge_m = std::max(cube.half_edge_m, within.cwiseAbs().maxCoeff());
  }
}

template <typename Swept>
void grow(Swept& swept, double by_m) {
  swept.radius_m += by_m;
}
void grow(Box& box, double by_m) { box.half_extents_m += Vector3::Constant(by_m); }
void grow(Cube& cube, double by_m) { cube.half_edge_m += by_m; }

bool holds_all(const Volume& volume, const std::vector<Vector3>& corners) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vector3& corner) { return holds(volume, corner); });
}

}  // namespace

Volume grown_to_hold(const Volume& volume, const std::vector<Vector3>& corners, double margin_m) {
  Volume grown = volume;
  std::visit([&](auto& kind) { refit(kind, corners); }, grown);
  double by_m = margin_m;
  std::visit([&](auto& kind) { grow(kind, by_m); }, grown);
  while (!holds_all(grown, corners)) {
    std::visit([&](auto& kind) { grow(kind, by_m); }, grown);
    by_m *= 2.0;
  }
  return grown;
}

Matrix3 small_turn(double x, double y, double z) {
  const double scale = 1.0 / std::sqrt(1.0 + square(x) + square(y) + square(z));
  return Quaternion(scale, scale * x, scale * y, scale * z).toRotationMatrix();
}

double extent_m(const std::vector<Vector3>& points) {
  Vector3 least = points.front();
  Vector3 most = least;
  for (const Vector3& point : points) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  return (most - least).maxCoeff();
}

}  // namespace impetus::inline trees
