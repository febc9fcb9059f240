// Eccentricity: collisions near the point of gaze first, and what the eye resolves away from it.
// (Dingliana 2002, sec. 5.2.1)
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

inline constexpr double kHalfAcuity_deg = 2.3;

/// How much of the fovea's acuity is left away from it, in (0, 1]: 1 where one looks.
///
///   share = e₂ / (e + e₂)     e₂ = 2.3°, at which half is left
///
/// (Geisler and Perry 1998: highest visible frequency f_c(e) = e₂ ln(1/CT₀) / (α (e + e₂)), here
/// over f_c(0), so neither α nor CT₀ remains)
inline double relative_acuity(double eccentricity_deg) {
  return kHalfAcuity_deg / (eccentricity_deg + kHalfAcuity_deg);
}

/// Measures how far from the point of gaze a collision is seen (degrees).
class EccentricityMetric final : public PriorityMetric {
 public:
  explicit EccentricityMetric(std::optional<ScreenPoint> point)
      : PriorityMetric(Urgent::kSmall), point_(point) {}
  [[nodiscard]] unsigned terms() const override { return point_ ? 0U : unsigned{kFixationTerm}; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override {
    return eccentricity_deg(bounds, viewer, fixation, point_);
  }

 private:
  std::optional<ScreenPoint> point_;
};

}  // namespace impetus::inline scheduling
