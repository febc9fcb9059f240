// The adaptive part of a design: its tracks, and the level of each adaptive trial in turn.
//
//   plan: track 0, 1, 1, 0, ...     trial --choose--> level and state, stored before it is shown
//                                         <--take---- the answer
//
// The same answers give the same levels, on every machine: resuming and replaying go through the
// answers again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/design/adaptive_track.hpp"
#include "experiments/design/plan.hpp"

namespace impetus::inline design {

/// One track: the levels of the other factors, and where it starts.
struct TrackPlan {
  Condition condition;   ///< without the adaptive factor
  std::size_t start{0};  ///< of a staircase: index of the level it begins at
};

/// The tracks of an adaptive design: every cell of the other factors, and in each every start.
std::vector<TrackPlan> adaptive_tracks(const Design& design);

class AdaptiveLevels {
 public:
  /// Every track at its beginning; none for a design that is not adaptive. Adaptive levels are
  /// numbers.
  explicit AdaptiveLevels(const Design& design);

  /// The level of an adaptive trial, which is the next of its track, and what it was chosen by.
  [[nodiscard]] ChosenLevel choose(const PlannedTrial& trial) const;

  /// The trial was shown, at the level in its condition, and answered. Trials without a track are
  /// passed over; of a level that is not the factor's, nothing is learned.
  void take(const PlannedTrial& shown, std::optional<bool> positive);

 private:
  Design design_;
  std::size_t factor_{0};  ///< the adaptive one
  std::vector<AdaptiveTrack> tracks_;
};

/// The trial's level has been chosen.
bool has_its_level(const PlannedTrial& trial, const Design& design);

}  // namespace impetus::inline design
