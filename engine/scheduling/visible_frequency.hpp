// Collisions where the eye resolves most detail first.
//
//   highest visible frequency = G(v) · M(e)      cycles per degree
//
//   G(v) = 60                       v ≤ 0.825°/s      M(e) = 1                   e ≤ 5.79°
//          57.69 − 27.78 log₁₀ v    to 118.3°/s              7.49 / (0.3 e + 1)²  beyond
//          0.1                      beyond
//
// (Reddy 1997, after Kelly, Rovamo and Virsu; suggested in Dingliana 2002, sec. 5.2.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// What speed leaves: the highest spatial frequency visible at the fovea (cycles per degree).
double frequency_seen_at_speed(double speed_deg_s);

/// What eccentricity leaves of it, in (0, 1].
double share_seen_at_eccentricity(double eccentricity_deg);

/// v is the mean speed at which the two bodies are seen to move, the camera's motion included; e
/// the eccentricity of the collision from `point`, or the fixation.
class VisibleFrequencyMetric final : public PriorityMetric {
 public:
  explicit VisibleFrequencyMetric(std::optional<ScreenPoint> point)
      : PriorityMetric(Urgent::kLarge), point_(point) {}
  [[nodiscard]] unsigned terms() const override {
    return kMotionTerm | (point_ ? 0U : unsigned{kFixationTerm});
  }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override;

 private:
  std::optional<ScreenPoint> point_;
};

}  // namespace impetus::inline scheduling
