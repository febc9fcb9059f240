// SPDX-License-Identifier: MIT
#include "engine/volumes/core.hpp"

#include <algorithm>
#include <cmath>
#include <compare>

namespace impetus {
namespace {

/// The axes of a block with those of no extent last.
Core with_flat_axes_last(const Vector3& centre, const Matrix3& axes, const Vector3& half_m) {
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

/// The core of a rectangle; a segment or a point when one half or both have no length.
Core core_between(const Vector3& centre, const Vector3& half_u, const Vector3& half_v) {
  const Vector3 lengths(half_u.norm(), half_v.norm(), 0.0);
  Core core;
  core.centre = centre;
  if (!(lengths[0] > 0.0) && !(lengths[1] > 0.0)) {
    return core;
  }
  Matrix3 axes;
  const bool u_leads = lengths[0] > 0.0;
  const Vector3 leading = u_leads ? half_u / lengths[0] : half_v / lengths[1];
  const bool both = u_leads && lengths[1] > 0.0;
  const Vector3 other = both ? Vector3(half_v / lengths[1]) : unit_across(leading);
  axes << leading, other, leading.cross(other);
  return with_flat_axes_last(centre, axes, u_leads ? lengths : Vector3(lengths[1], 0.0, 0.0));
}

CoredVolume cored_of(const Sphere& sphere) {
  Core core;
  core.centre = sphere.centre;
  return {core, sphere.radius_m};
}
CoredVolume cored_of(const LineSwept& line) {
  return {core_between(line.centre, line.half_axis, Vector3::Zero()), line.radius_m};
}
CoredVolume cored_of(const RectangleSwept& rectangle) {
  return {core_between(rectangle.centre, rectangle.half_u, rectangle.half_v), rectangle.radius_m};
}
CoredVolume cored_of(const Box& box) {
  return {with_flat_axes_last(box.centre, box.orientation.toRotationMatrix(), box.half_extents_m),
          0.0};
}
CoredVolume cored_of(const Cube& cube) {
  return cored_of(Box{cube.centre, Vector3::Constant(cube.half_edge_m), cube.orientation});
}

}  // namespace

CoredVolume cored(const Volume& volume) {
  return std::visit([](const auto& kind) { return cored_of(kind); }, volume);
}

bool comes_after(const CoredVolume& a, const CoredVolume& b) {
  const auto compared = [](const auto& of_a, const auto& of_b) {
    return std::lexicographical_compare_three_way(of_a.data(), of_a.data() + of_a.size(),
                                                  of_b.data(), of_b.data() + of_b.size());
  };
  std::partial_ordering order = compared(a.core.centre, b.core.centre);
  if (order == 0) {
    order = compared(a.core.half_m, b.core.half_m);
  }
  if (order == 0) {
    order = compared(a.core.axes, b.core.axes);
  }
  return order == 0 ? a.radius_m > b.radius_m : order > 0;
}

double bounding_radius_m(const Core& core) { return core.half_m.norm(); }

double reach_along(const Core& core, const Vector3& direction) {
  double reach = 0.0;
  for (int axis = 0; axis < core.dimension; ++axis) {
    reach += core.half_m[axis] * std::abs(core.axes.col(axis).dot(direction));
  }
  return reach;
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

}  // namespace impetus
