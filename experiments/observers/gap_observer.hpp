// A simulated participant of the gap study: belief falls with the gap that could be seen.
//
//   seen = γ + (1 − γ − λ) Φ(log₁₀(g / g₅₀) / width),   g₅₀ = threshold · (1 + e/2.3) · (60 / G(v))
//
// g is the gap in minutes of arc after foreshortening, less its hidden share; e its eccentricity
// from the screen's centre (degrees); v the speed at which the bodies close in (degrees per
// second); G Reddy's visible frequency at that speed (Reddy 1997). The parameters are in
// experiments/observers/gap.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/observers/gap_visibility.hpp"
#include "experiments/observers/rating_observer.hpp"

namespace impetus {

struct GapParameters : RatingParameters {
  double threshold_arcmin{10.0};  ///< g₅₀ at the centre, at rest
  double width_log10{0.2};
  double guess_rate{0.0};  ///< γ
  double miss_rate{0.0};   ///< λ
};

class GapObserver final : public RatingObserver {
 public:
  GapObserver(const GapParameters& parameters, std::uint64_t seed, const std::string& pseudonym,
              VirtualClock& clock);

  /// Probability that a gap is seen.
  [[nodiscard]] double seen_gap(double visible_arcmin, double eccentricity_deg,
                                double speed_deg_s) const;

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;

  GapParameters parameters_;
};

}  // namespace impetus
