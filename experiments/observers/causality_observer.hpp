// A simulated participant of the causality study: belief in the collision falls with its delay.
//
//   seen = Φ((τ − μ_i) / σ)
//
// τ is the freeze that was really shown; μ_i belongs to the participant. The parameters are in
// experiments/observers/causality.json.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {

/// What a participant of the causality study is made of.
struct CausalityParameters : RatingParameters {
  double threshold_mean_ms{0.0};  ///< μ over participants
  double threshold_sd_ms{0.0};
  double threshold_width_ms{1.0};  ///< σ of the psychometric function
};

/// Judges the longest freeze of all that was shown.
class CausalityObserver final : public RatingObserver {
 public:
  CausalityObserver(const CausalityParameters& parameters, const Birth& birth);

  /// Probability of each rating 1, 2, 3 for a delay.
  [[nodiscard]] std::vector<double> rating_probabilities(double delay_ms) const {
    return probabilities(seen_at(delay_ms));
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;
  [[nodiscard]] double seen_at(double delay_ms) const;

  CausalityParameters parameters_;
};

}  // namespace impetus::inline observers
