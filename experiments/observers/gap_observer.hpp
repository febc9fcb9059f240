// A simulated participant of the gap study: belief falls with the gap that could be seen.
//
//   seen = γ + (1 − γ − λ) Φ(log₁₀(g / g₅₀) / width)
//   g₅₀  = threshold · 10^t_i · (1 + e/2.3) · (60 / G(v)) · (1 + crowding · (N − 2))
//
// g is the gap in minutes of arc after foreshortening, less its hidden share; e its eccentricity
// from the screen's centre (degrees); v the speed at which the bodies close in (degrees per
// second); G Reddy's visible frequency at that speed (Reddy 1997); N the number of bodies. t_i
// belongs to the participant. The parameters are in experiments/observers/gap.json, where neither
// crowd nor t matters, and gap-thresholds.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/observers/gap_visibility.hpp"
#include "experiments/observers/rating_observer.hpp"

namespace impetus::inline observers {

struct GapParameters : RatingParameters {
  double threshold_arcmin{10.0};  ///< g₅₀ at the centre, at rest
  double width_log10{0.2};
  double guess_rate{0.0};          ///< γ
  double miss_rate{0.0};           ///< λ
  double crowding_per_body{0.0};   ///< of g₅₀, for each body beyond two
  double threshold_sd_log10{0.0};  ///< of t over participants
};

/// The same where thresholds are sought: crowd and t are in the file.
struct GapThresholdParameters : GapParameters {};

class GapObserver : public RatingObserver {
 public:
  GapObserver(const GapParameters& parameters, std::uint64_t seed, const std::string& pseudonym,
              VirtualClock& clock, const std::string& study = "gap");

  /// Probability that a gap is seen.
  [[nodiscard]] double seen_gap(double visible_arcmin, double eccentricity_deg, double speed_deg_s,
                                std::size_t bodies = 2) const;

  /// g₅₀ (minutes of arc) of this participant.
  [[nodiscard]] double threshold_arcmin(double eccentricity_deg, double speed_deg_s,
                                        std::size_t bodies) const;

 protected:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;

 private:
  GapParameters parameters_;
  double threshold_log10_{0.0};  ///< t
};

}  // namespace impetus::inline observers
