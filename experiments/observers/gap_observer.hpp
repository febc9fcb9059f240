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

#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {

/// The highest spatial frequency visible at a speed (cycles per degree; Reddy 1997).
double visible_frequency_at(double speed_deg_s);

/// g₅₀ (minutes of arc) at an eccentricity (degrees) and a speed, from what it is at the point of
/// gaze and at rest. It doubles at 2.3° (Geisler and Perry 1998).
double gap_threshold_arcmin(double at_rest_arcmin, double eccentricity_deg, double speed_deg_s);

/// What a participant of the gap study is made of.
struct GapParameters : RatingParameters {
  double threshold_arcmin{10.0};  ///< g₅₀ at the centre, at rest
  double width_log10{0.2};
  double guess_rate{0.0};          ///< γ
  double miss_rate{0.0};           ///< λ
  double crowding_per_body{0.0};   ///< of g₅₀, for each body beyond two
  double threshold_sd_log10{0.0};  ///< of t over participants
};

/// The probability that a gap of so many minutes of arc is seen, among so many bodies.
double seen_gap(const GapParameters& own, const Traits& traits, double visible_arcmin,
                double eccentricity_deg, double speed_deg_s, double bodies);

/// The numbers that all who look for gaps have.
std::vector<ParameterEntry> gap_entries(GapParameters& gap);

/// He judges the clearest gap between two bodies of all that was shown.
const ObserverKind& gap_observer();

}  // namespace impetus::inline observers
