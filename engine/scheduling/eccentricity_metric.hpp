// Collisions near the point of gaze first. (Dingliana 2002, sec. 5.2.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// Degrees between the place of the collision and what is looked at: `point` where one is given,
/// else the fixation, else the screen's centre.
inline double eccentricity_deg(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation, const std::optional<ScreenPoint>& point) {
  const ScreenPoint looked_at = point ? *point : fixation.value_or(ScreenPoint{});
  return visual_angle_deg(viewer, collision_place(bounds), on_screen(viewer, looked_at));
}

class EccentricityMetric final : public PriorityMetric {
 public:
  explicit EccentricityMetric(std::optional<ScreenPoint> point)
      : PriorityMetric(Urgent::kSmall), point_(point) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override {
    return eccentricity_deg(bounds, viewer, fixation, point_);
  }

 private:
  std::optional<ScreenPoint> point_;
};

}  // namespace impetus::inline scheduling
