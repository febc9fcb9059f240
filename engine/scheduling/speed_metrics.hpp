// Slow collisions first: by the bodies' own speeds on the screen, or by that of one past the other.
// (Dingliana 2002, sec. 5.2.1; eq. 5.1, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// Degrees per second at which the two bodies are seen to move, mean.
inline double mean_seen_speed_deg_s(const PairBounds& bounds, const Viewer& viewer) {
  return 0.5 * (angular_speed_deg_s(viewer, bounds.a.centre, bounds.velocity_a) +
                angular_speed_deg_s(viewer, bounds.b.centre, bounds.velocity_b));
}

/// Measures the mean speed of both bodies across the screen (degrees a second).
class VelocityMetric final : public PriorityMetric {
 public:
  VelocityMetric() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] unsigned terms() const override { return kMotionTerm; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return mean_seen_speed_deg_s(bounds, viewer);
  }
};

/// Degrees per second that the velocity of one body relative to the other, or to the wall, spans
/// at the place of the collision. There the camera's motion is the same for both, and cancels.
class CollisionSpeedMetric final : public PriorityMetric {
 public:
  CollisionSpeedMetric() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] unsigned terms() const override { return kMotionTerm; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    Vector3 relative = bounds.velocity_a;
    if (!is_wall(bounds.pair.b)) {
      relative -= bounds.velocity_b;
    }
    Viewer at_rest = viewer;
    at_rest.velocity.setZero();
    at_rest.turning.setZero();
    return angular_speed_deg_s(at_rest, collision_place(bounds), relative);
  }
};

}  // namespace impetus::inline scheduling
