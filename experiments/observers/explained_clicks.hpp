// How probable clicks are when each event is followed by one with a certain probability, after a
// lognormal time, among false ones: what a simulated participant draws, the other way round.
//
//   event ──(seen?)── waiting ──click──>        each event is followed on its own, or with those
//                        │                      of which one at most was seen: waiting, or has
//                        │                      clicked, or was never seen
//   silence: who waits becomes less likely      (assumed-density filtering, Maybeck 1982)
//   a click: one of those who wait, or a false one, each by its hazard
//   after it, for a while: clicks come unnoticed
//
// Exact while no two events wait at once; where they do, what is known of them together is taken
// for independent.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace impetus::inline observers {

/// Something that may have been seen, and how probably it was.
struct PossibleEvent {
  double at_s{0.0};
  double chance{0.0};
  /// To the event before it: of a run of alternatives, and the event that it follows, one at most
  /// was seen.
  bool is_alternative{false};
};

/// How clicks follow events.
struct ClickHabit {
  double median_s{0.5};
  double sigma_log{0.25};
  double refractory_s{0.0};
  double false_per_s{0.0};
};

/// The logarithm of the probability density of clicks at `clicks_s` (rising) and at no other time
/// until `stimulus_s`. The events, in order of time, then have their chances in the light of the
/// clicks.
double explain_clicks(const ClickHabit& habit, const std::vector<double>& clicks_s,
                      double stimulus_s, std::vector<PossibleEvent>& events);

/// The chance that 0, 1, 2, ... of the events were seen: each on its own, of alternatives one.
std::vector<double> chances_of_count(const std::vector<PossibleEvent>& events);

}  // namespace impetus::inline observers
