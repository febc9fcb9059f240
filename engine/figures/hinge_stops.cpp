// SPDX-License-Identifier: MIT
#include "engine/figures/hinge_stops.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline figures {
namespace {

const Pose& pose_of(std::int32_t body, const std::vector<BodyState>& states) {
  return states[static_cast<std::size_t>(body)].pose;
}

}  // namespace

void add_stops(std::span<const Figure> figures, std::size_t figure,
               const std::vector<BodyState>& states, double dt_s, std::vector<HingeStop>& stops) {
  const std::vector<Hinge>& hinges = figures[figure].hinges;
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    if (!hinge.is_limited()) {
      continue;
    }
    const Pose& parent = pose_of(hinge.parent, states);
    const double angle = angle_of(hinge, pose_of(hinge.child, states), parent);
    const Vector3 axis = parent.orientation * hinge.of_parent.axis;
    const auto add = [&](double room_rad, const Vector3& away) {
      if (room_rad < kStopReach) {
        stops.push_back({figure, i, away, dt_s > 0.0 ? std::max(0.0, room_rad) / dt_s : 0.0});
      }
    };
    add(angle - hinge.least_rad, axis);
    add(hinge.most_rad - angle, -axis);
  }
}

Vector3 opening_axis(const Hinge& hinge, const Pose& child, const Pose& parent) {
  const Vector3 across =
      (parent.orientation * hinge.of_parent.core).cross(child.orientation * hinge.of_child.core);
  const double length = across.norm();
  return length > 1e-9 ? Vector3(across / length)
                       : Vector3(parent.orientation * hinge.of_parent.axis);
}

const Hinge* hinge_between(const Figure& figure, BodyPair parts) {
  const std::int32_t child = std::max(parts.a, parts.b);
  const std::int32_t parent = std::min(parts.a, parts.b);
  if (!figure.has_part(child) || !figure.has_part(parent) || child == figure.first_part) {
    return nullptr;
  }
  const Hinge& hinge = figure.hinges[static_cast<std::size_t>(child - figure.first_part) - 1];
  return hinge.parent == parent ? &hinge : nullptr;
}

void add_folds(const Figure& figure, std::span<const double> rest_openings,
               const std::vector<BodyState>& states, std::vector<Contact>& folds) {
  for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
    const Hinge& hinge = figure.hinges[i];
    if (!std::isfinite(hinge.fold_rad)) {
      continue;
    }
    const Pose& child = pose_of(hinge.child, states);
    const Pose& parent = pose_of(hinge.parent, states);
    const double beyond_rad = rest_openings[i] - hinge.fold_rad - opening_of(hinge, child, parent);
    if (!(beyond_rad > 0.0)) {
      continue;
    }
    Contact fold;
    fold.bodies = {hinge.parent, hinge.child};
    fold.touch.point = child.transform(hinge.of_child.anchor);
    const Vector3 apart = parent.position - child.position;
    fold.touch.normal =
        apart.norm() > 0.0 ? Vector3(apart.normalized()) : Vector3(Vector3::UnitX());
    fold.touch.depth_m =
        beyond_rad * std::min(hinge.of_child.anchor.norm(), hinge.of_parent.anchor.norm());
    folds.push_back(fold);
  }
}

}  // namespace impetus::inline figures
