// A simulated participant of the gaze-contingent study: clicks at collisions that look bad, and
// rates by how many there were.
//
//   collision ── gap seen? ──> events ── reaction time, refractory ──> clicks <── false ones
//                               └── per second ──> badness ──> rating
//
//   P(seen) = (1 − λ) Φ(log₁₀(g / g₅₀) / width)
//   g₅₀     = threshold · (1 + e/2.3) · (60 / G(v)) · (1 + crowding · (N − 2))
//   badness = 1 − exp(−rate of events / scale)
//
// g is the gap in minutes of arc less its hidden share, between two bodies or a body and a wall; e
// its eccentricity from the gaze, or from the screen's centre when gaze was not followed (degrees);
// v the speed at which they close in (degrees per second); G Reddy's visible frequency at that
// speed (Reddy 1997); N the number of bodies. Nothing is guessed at a collision: what is not seen
// is clicked only by the false clicks, which come at a rate of their own. The parameters are in
// experiments/observers/gaze-contingent.json; crowd.json has the same participant before crowds.
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "experiments/observers/gap_observer.hpp"
#include "experiments/observers/simulated_eye.hpp"

namespace impetus::inline observers {

/// What a participant of the gaze-contingent study is made of, its eye included.
struct GazeObserverParameters : GapParameters, EyeParameters {
  double merge_ms{100.0};         ///< collisions closer than this are one event
  double click_median_ms{550.0};  ///< from event to click; lognormal
  double click_sigma_log{0.25};
  double refractory_ms{400.0};  ///< after a click, in which there is no other
  double false_clicks_per_s{0.0};
  double events_per_s{1.0};  ///< the scale of badness
};

/// Clicks at what it saw, and judges how often that was.
class GazeObserver final : public RatingObserver {
 public:
  GazeObserver(const GazeObserverParameters& parameters, const Birth& birth);

  /// Nothing during the stimulus; after witnessed(), once, all clicks of the stimulus.
  std::vector<ClickRecord> take_clicks() override { return std::exchange(clicks_, {}); }

  Gaze* eye() override { return &eye_; }

  /// Probability that a collision's gap is seen; 0 where there is no gap.
  [[nodiscard]] double seen_gap(double visible_arcmin, double eccentricity_deg, double speed_deg_s,
                                std::size_t bodies) const;

 private:
  [[nodiscard]] double seen(const AttemptRecord& shown, const StagedScene& scene) override;
  /// Whether a collision is seen: when `draw` (0–1) is below the probability that its gap is.
  [[nodiscard]] bool sees(double draw, const CollisionRecord& collision,
                          const StagedScene& scene) const;
  [[nodiscard]] std::vector<double> draw_events_s(const AttemptRecord& shown,
                                                  const StagedScene& scene);
  [[nodiscard]] std::vector<double> draw_clicks_s(const std::vector<double>& events_s,
                                                  double stimulus_s);

  GazeObserverParameters parameters_;
  RandomStream click_stream_;
  SimulatedEye eye_;
  std::vector<ClickRecord> clicks_;
};

}  // namespace impetus::inline observers
