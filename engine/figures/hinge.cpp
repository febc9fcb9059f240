// SPDX-License-Identifier: MIT
#include "engine/figures/hinge.hpp"

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline figures {
namespace {

constexpr double kPi = 3.141592653589793;

bool is_unit(const Vector3& v) { return std::abs(v.squaredNorm() - 1.0) < 1e-9; }

Quaternion turn_about(const Vector3& axis, double angle_rad) {
  const SineCosine half = sine_cosine_deg(0.5 * angle_rad * kDegreesPerRadian);
  return {half.cosine, half.sine * axis.x(), half.sine * axis.y(), half.sine * axis.z()};
}

/// Turns the frame (axis, zero, axis × zero) of one side into that of the other.
Quaternion frame_of(const HingeSide& side) {
  Matrix3 frame;
  frame << side.axis, side.zero, side.axis.cross(side.zero);
  return Quaternion(frame);
}

/// A number of the limits about which angles are told: their middle, where there are both.
double middle_of(const Hinge& hinge) {
  const double middle = 0.5 * (hinge.least_rad + hinge.most_rad);
  return std::isfinite(middle) ? middle : 0.0;
}

/// Of two directions, 0 to π.
double angle_between(const Vector3& a, const Vector3& b) {
  return atan2_rad(a.cross(b).norm(), a.dot(b));
}

std::string problem_of(const HingeSide& side, const std::string& name) {
  for (const Vector3* v : {&side.axis, &side.zero, &side.core}) {
    if (!is_unit(*v)) {
      return "expected directions of unit length on the " + name + "'s side, got one of " +
             std::to_string(v->norm());
    }
  }
  if (!side.anchor.allFinite()) {
    return "expected an anchor of finite numbers on the " + name + "'s side";
  }
  return std::abs(side.axis.dot(side.zero)) < 1e-9
             ? ""
             : "expected a zero direction across the axis on the " + name + "'s side";
}

bool is_within_half_turn(double angle_rad) { return angle_rad >= -kPi && angle_rad <= kPi; }

}  // namespace

double angle_of(const Hinge& hinge, const Pose& child, const Pose& parent) {
  const Vector3 axis = parent.orientation * hinge.of_parent.axis;
  const Vector3 from = parent.orientation * hinge.of_parent.zero;
  const Vector3 to = child.orientation * hinge.of_child.zero;
  const double angle = atan2_rad(axis.dot(from.cross(to)), from.dot(to));
  const double middle = middle_of(hinge);
  return angle > middle + kPi   ? angle - 2.0 * kPi
         : angle < middle - kPi ? angle + 2.0 * kPi
                                : angle;
}

double opening_of(const Hinge& hinge, const Pose& child, const Pose& parent) {
  return angle_between(child.orientation * hinge.of_child.core,
                       parent.orientation * hinge.of_parent.core);
}

double opening_at_rest(const Hinge& hinge) {
  const Pose parent;
  return opening_of(hinge, hung_from(hinge, parent, hinge.rest_rad), parent);
}

bool is_folded(const Hinge& hinge, const Pose& child, const Pose& parent) {
  return std::isfinite(hinge.fold_rad) &&
         opening_of(hinge, child, parent) < opening_at_rest(hinge) - hinge.fold_rad;
}

double anchor_gap_m(const Hinge& hinge, const Pose& child, const Pose& parent) {
  return (child.transform(hinge.of_child.anchor) - parent.transform(hinge.of_parent.anchor)).norm();
}

Pose hung_from(const Hinge& hinge, const Pose& parent, double angle_rad) {
  const Quaternion in_parent = turn_about(hinge.of_parent.axis, angle_rad) *
                               frame_of(hinge.of_parent) * frame_of(hinge.of_child).conjugate();
  Pose child;
  child.orientation = (parent.orientation * in_parent).normalized();
  child.position =
      parent.transform(hinge.of_parent.anchor) - child.orientation * hinge.of_child.anchor;
  return child;
}

std::string problem_of(const Hinge& hinge) {
  for (const std::string& problem :
       {problem_of(hinge.of_child, "child"), problem_of(hinge.of_parent, "parent")}) {
    if (!problem.empty()) {
      return problem;
    }
  }
  if (!is_within_half_turn(hinge.rest_rad)) {
    return "expected a rest angle from -180 to 180 degrees, got " +
           std::to_string(degrees(hinge.rest_rad));
  }
  if (hinge.is_limited() &&
      !(is_within_half_turn(hinge.least_rad) && is_within_half_turn(hinge.most_rad) &&
        hinge.least_rad < hinge.most_rad)) {
    return "expected limits that rise within -180 to 180 degrees, got " +
           std::to_string(degrees(hinge.least_rad)) + " and " +
           std::to_string(degrees(hinge.most_rad));
  }
  if (!(hinge.rest_rad >= hinge.least_rad && hinge.rest_rad <= hinge.most_rad)) {
    return "expected a rest angle within the limits, got " +
           std::to_string(degrees(hinge.rest_rad)) + " degrees";
  }
  return hinge.fold_rad > 0.0 ? ""
                              : "expected a fold threshold above 0, got " +
                                    std::to_string(degrees(hinge.fold_rad)) + " degrees";
}

}  // namespace impetus::inline figures
