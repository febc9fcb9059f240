// A simulated participant of the causality study: belief in the collision falls with its delay.
//
//   P(rating ≤ k) = logistic(cut_k − η),   η = baseline + effect · Φ((τ − μ_i) / σ) + u_i
//
// τ is the freeze that was really shown; μ_i and u_i belong to the participant. With a small
// probability the participant lapses and answers anything. All parameters are data, each marked
// as taken from a source or assumed: experiments/observers/causality.json.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/session/ports.hpp"

namespace impetus {

struct CausalityParameters {
  double baseline{0.0};           ///< logits
  double delay_effect{0.0};       ///< logits, at an endless delay
  double threshold_mean_ms{0.0};  ///< μ over participants
  double threshold_sd_ms{0.0};
  double threshold_width_ms{1.0};  ///< σ of the psychometric function
  double intercept_sd{0.0};        ///< of u over participants, logits
  std::array<double, 2> cuts{};    ///< between ratings 1|2 and 2|3, logits
  double lapse_rate{0.0};
  double reaction_median_ms{500.0};
  double reaction_sigma_log{0.25};  ///< lognormal
};

class CausalityObserver final : public Input {
 public:
  /// The participant's own traits and every answer follow from `seed` and `pseudonym`.
  CausalityObserver(const CausalityParameters& parameters, std::uint64_t seed,
                    const std::string& pseudonym, VirtualClock& clock);

  Answer ask(const Page& page) override;
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown) override;

  /// Probability of each rating 1, 2, 3 for a delay, lapses included; adds up to 1.
  [[nodiscard]] std::array<double, 3> rating_probabilities(double delay_ms) const;

 private:
  double normal();

  CausalityParameters parameters_;
  VirtualClock* clock_;
  RandomStream stream_;
  double threshold_ms_;
  double intercept_;
  double witnessed_delay_ms_{0.0};
};

}  // namespace impetus
