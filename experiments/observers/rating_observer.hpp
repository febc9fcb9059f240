// A simulated participant who answers a trial's questions by how clearly something wrong was seen.
//
// Rating: disbelief grows with it.
//
//   P(disbelief ≤ k) = logistic(cut_k − η),   η = baseline + (effect + s_i) · seen + u_i
//
//   disbelief   0     1     2     3     4        the distance from the scale's good end,
//   rating      1     2     3                    whichever end that is
//   or          5     4     3     2     1
//
// Yes or no: P(yes) = γ + (1 − γ − λ) · seen. Where the study's own `seen` has these rates in it,
// they are 0 here.
//
// Two intervals: P(the first) = ½ + ½ (1 − lapse rate) (seen₁ − seen₂). This is what guessing gives
// where something is seen in both intervals or in neither: with s₁ and s₂ the chances to see it,
// s₁(1 − s₂) + ½[s₁s₂ + (1 − s₁)(1 − s₂)] = ½ + ½(s₁ − s₂), the high-threshold observer (Green and
// Swets 1966). A lapse chooses either, so the asymptote is 1 − ½ lapse rate.
//
// Words are left out. An answer later than a page's time is not given.
//
// `seen`, from 0 to 1, is the study's own: what a derived observer makes of what was shown. u_i
// and s_i belong to the participant. With a small probability the participant lapses and answers
// anything. All parameters are data, each marked as taken from a source or assumed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/observers/draws.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline observers {

/// What every simulated participant is made of; each kind adds its own.
struct RatingParameters {
  double baseline{0.0};      ///< logits
  double effect{0.0};        ///< logits, of what was clearly seen
  double effect_sd{0.0};     ///< of s over participants, logits
  double intercept_sd{0.0};  ///< of u over participants, logits
  std::vector<double> cuts;  ///< between neighbouring points from the good end on; logits, rising
  double lapse_rate{0.0};
  double reaction_median_ms{500.0};
  double reaction_sigma_log{0.25};  ///< lognormal
  double yes_guess_rate{0.0};       ///< γ: yes where nothing was seen
  double yes_miss_rate{0.0};        ///< λ: no where it was clearly seen

  /// Points of the scales that can be answered on.
  [[nodiscard]] std::size_t points() const { return cuts.size() + 1; }
};

/// Judges what was shown and answers as the kind of each question says.
class RatingObserver : public Input, public Judge {
 public:
  /// A scale must have as many choices as there are points().
  Answer ask(const Page& page) override;
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override;

  /// Lapses included; they add up to 1.
  [[nodiscard]] std::vector<double> probabilities(double seen) const override;
  [[nodiscard]] double yes_probability(double seen) const override;
  [[nodiscard]] double first_probability(double seen_first, double seen_second) const override;
  [[nodiscard]] const std::vector<double>& seen_in_intervals() const override { return seen_; }
  double uniform() override { return stream_.uniform(); }

  /// The eye of an observer that has one; it lives as long as the observer.
  virtual Gaze* eye() { return nullptr; }

 protected:
  /// The participant's traits and every answer follow from `stream`.
  RatingObserver(RatingParameters parameters, RandomStream stream, VirtualClock& clock)
      : parameters_(std::move(parameters)), clock_(&clock), stream_(stream) {}

  /// How clearly something wrong was seen in what was shown, from 0 to 1. Called once per trial,
  /// and once per interval where there are two.
  [[nodiscard]] virtual double seen(const AttemptRecord& shown, const StagedScene& scene) = 0;

  /// Draws the participant's intercept and slope; a derived constructor calls it once, after the
  /// traits of its own.
  void draw_traits();
  double normal() { return draw_normal(stream_); }

 private:
  RatingParameters parameters_;
  VirtualClock* clock_;
  RandomStream stream_;
  double intercept_{0.0};
  double slope_{0.0};
  std::vector<double> seen_{0.0};  ///< in each interval of the trial
};

}  // namespace impetus::inline observers
