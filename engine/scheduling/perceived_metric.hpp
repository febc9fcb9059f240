// Collisions whose error people would notice first: the probability that the gap that a pair may be
// left with is seen, by an observer who was fitted to people's answers.
//
//   P = (1 − λ) Φ(log₁₀(g / g₅₀) / width)      g₅₀ = threshold · (1 + e / 2.3°) · 60 / G(v)
//
// g is the angle that the pair's gap cannot exceed at the level it stands at (gap-bound), e the
// eccentricity of the collision from where one looks, v the speed at which the bodies close in, and
// G(v) what can be seen at that speed (Reddy 1997). The traversal visible-first takes the same
// probability of the gaps that work can remove. It is the form of the simulated participant of
// the gaze-contingent study, whose parameters `impetus fit` finds.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/metrics.hpp"

namespace impetus::inline scheduling {

/// The gap that is noticed half of the time, but for misses, at this eccentricity and speed.
double noticed_threshold_arcmin(const Noticing& noticing, double eccentricity_deg,
                                double speed_deg_s);

/// The probability that a gap is noticed where this is the threshold: none that is not above 0 is.
double noticed_share(const Noticing& noticing, double gap_arcmin, double threshold_arcmin);

/// The threshold at which the error of a pair would be noticed, as it is seen from there.
double noticed_threshold_arcmin(const Noticing& noticing, const PairBounds& bounds,
                                const Viewer& viewer, const Fixation& fixation,
                                const std::optional<ScreenPoint>& point);

/// Measures the probability that the gap which a pair may be left with would be noticed.
class PerceivedMetric final : public PriorityMetric {
 public:
  PerceivedMetric(const Noticing& noticing, std::optional<ScreenPoint> point)
      : PriorityMetric(Urgent::kLarge), noticing_(noticing), point_(point) {}
  [[nodiscard]] unsigned terms() const override {
    return kFitErrorTerm | kMotionTerm | (point_ ? 0U : unsigned{kFixationTerm});
  }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override;
  [[nodiscard]] const Noticing* noticing() const override { return &noticing_; }

 private:
  Noticing noticing_;
  std::optional<ScreenPoint> point_;
};

}  // namespace impetus::inline scheduling
