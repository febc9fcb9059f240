// A simulated participant who rates: disbelief grows with how clearly something wrong was seen.
//
//   P(rating ≤ k) = logistic(cut_k − η),   η = baseline + (effect + s_i) · seen + u_i
//
// `seen`, from 0 to 1, is the study's own: what a derived observer makes of what was shown. u_i
// and s_i belong to the participant. With a small probability the participant lapses and answers
// anything. All parameters are data, each marked as taken from a source or assumed.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/session/ports.hpp"

namespace impetus {

struct RatingParameters {
  double baseline{0.0};      ///< logits
  double effect{0.0};        ///< logits, of what was clearly seen
  double effect_sd{0.0};     ///< of s over participants, logits
  double intercept_sd{0.0};  ///< of u over participants, logits
  double cut_1_2{0.0};       ///< between ratings 1 and 2, logits
  double cut_2_3{0.0};
  double lapse_rate{0.0};
  double reaction_median_ms{500.0};
  double reaction_sigma_log{0.25};  ///< lognormal
};

class RatingObserver : public Input {
 public:
  Answer ask(const Page& page) override;
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override {
    seen_ = seen(shown, scene);
  }

  /// Probability of each rating 1, 2, 3 for what was seen, lapses included; adds up to 1.
  [[nodiscard]] std::array<double, 3> probabilities(double seen) const;

 protected:
  /// The participant's traits and every answer follow from `stream`.
  RatingObserver(const RatingParameters& parameters, RandomStream stream, VirtualClock& clock)
      : parameters_(parameters), clock_(&clock), stream_(stream) {}

  /// How clearly something wrong was seen in what was shown, from 0 to 1.
  [[nodiscard]] virtual double seen(const AttemptRecord& shown, const StagedScene& scene) const = 0;

  /// Draws the participant's intercept and slope; a derived constructor calls it once, after the
  /// traits of its own.
  void draw_traits();
  double normal();

 private:
  RatingParameters parameters_;
  VirtualClock* clock_;
  RandomStream stream_;
  double intercept_{0.0};
  double slope_{0.0};
  double seen_{0.0};
};

/// Φ, the standard normal distribution function.
double normal_cdf(double z);

}  // namespace impetus
