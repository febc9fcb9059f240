// SPDX-License-Identifier: MIT
#include "experiments/run/seen_apart.hpp"

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline run {
namespace {

/// The angle between two orientations.
double turn_deg(const Quaternion& x, const Quaternion& y) {
  const Quaternion between = x.conjugate() * y;
  return degrees(2.0 * atan2_rad(between.vec().norm(), std::abs(between.w())));
}

}  // namespace

bool seen_apart(const Pose& x, const Pose& y, bool turns_show, const Viewer& viewer,
                const PartingThresholds& thresholds) {
  const bool same_place =
      visual_angle_deg(viewer, x.position, y.position) < thresholds.position_deg;
  const bool same_turn =
      !turns_show || turn_deg(x.orientation, y.orientation) < thresholds.turn_deg;
  return !same_place || !same_turn;
}

}  // namespace impetus::inline run
