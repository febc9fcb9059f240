// SPDX-License-Identifier: MIT
#include "engine/volumes/core.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

namespace impetus::inline volumes {

Core point_core(const Vector3& centre) {
  Core core;
  core.centre = centre;
  return core;
}

Core rectangle_core(const Vector3& centre, const Vector3& half_u, const Vector3& half_v) {
  const double u_m = half_u.norm();
  const double v_m = half_v.norm();
  if (!(u_m > 0.0) && !(v_m > 0.0)) {
    return point_core(centre);
  }
  const Vector3 first = u_m > 0.0 ? half_u / u_m : half_v / v_m;
  const Vector3 second = u_m > 0.0 && v_m > 0.0 ? Vector3(half_v / v_m) : unit_across(first);
  Matrix3 axes;
  axes << first, second, first.cross(second);
  const Vector3 half_m = u_m > 0.0 ? Vector3(u_m, v_m, 0.0) : Vector3(v_m, 0.0, 0.0);
  return block_core(centre, axes, half_m);
}

Core block_core(const Vector3& centre, const Matrix3& axes, const Vector3& half_m) {
  Core core;
  core.centre = centre;
  int last = 2;
  for (int axis = 0; axis < 3; ++axis) {
    const bool extended = half_m[axis] > 0.0;
    const int place = extended ? core.dimension++ : last--;
    core.axes.col(place) = axes.col(axis);
    core.half_m[place] = extended ? half_m[axis] : 0.0;
  }
  return core;
}

bool comes_after(const CoredVolume& a, const CoredVolume& b) {
  static constexpr std::partial_ordering kAlike = std::partial_ordering::equivalent;
  const auto compared = [](const auto& of_a, const auto& of_b) {
    std::partial_ordering order = kAlike;
    for (Eigen::Index i = 0; order == kAlike && i < of_a.size(); ++i) {
      order = of_a.data()[i] <=> of_b.data()[i];
    }
    return order;
  };
  std::partial_ordering order = compared(a.core.centre, b.core.centre);
  if (order == kAlike) {
    order = compared(a.core.half_m, b.core.half_m);
  }
  if (order == kAlike) {
    order = compared(a.core.axes, b.core.axes);
  }
  return order == kAlike ? a.radius_m > b.radius_m : order == std::partial_ordering::greater;
}

double bounding_radius_m(const Core& core) { return core.half_m.norm(); }

double reach_along(const Core& core, const Vector3& direction) {
  double reach = 0.0;
  for (int axis = 0; axis < core.dimension; ++axis) {
    reach += core.half_m[axis] * std::abs(core.axes.col(axis).dot(direction));
  }
  return reach;
}

Vector3 furthest_part(const Core& core, const Vector3& direction) {
  constexpr double kParallel = 1e-9;  // cosine below which an axis runs along the part
  Vector3 middle = core.centre;
  for (int axis = 0; axis < core.dimension; ++axis) {
    const double cosine = core.axes.col(axis).dot(direction);
    if (std::abs(cosine) > kParallel) {
      middle += (cosine > 0.0 ? core.half_m[axis] : -core.half_m[axis]) * core.axes.col(axis);
    }
  }
  return middle;
}

Vector3 nearest_point(const Core& core, const Vector3& point) {
  const Vector3 offset = point - core.centre;
  Vector3 nearest = core.centre;
  for (int axis = 0; axis < core.dimension; ++axis) {
    const double half_m = core.half_m[axis];
    nearest += std::clamp(core.axes.col(axis).dot(offset), -half_m, half_m) * core.axes.col(axis);
  }
  return nearest;
}

Vector3 unit_across(const Vector3& direction) {
  Eigen::Index flattest = 0;
  direction.cwiseAbs().minCoeff(&flattest);
  return direction.cross(Vector3(Vector3::Unit(flattest))).normalized();
}

}  // namespace impetus::inline volumes
