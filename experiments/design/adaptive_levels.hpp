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
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/design/quest_plus.hpp"
#include "experiments/design/staircase.hpp"

namespace impetus::inline design {

/// One adaptive track: the levels of its trials, each decided by the answers before it.
class AdaptiveTrack {
 public:
  explicit AdaptiveTrack(std::variant<StaircaseTrack, QuestPlusTrack> method)
      : method_(std::move(method)) {}

  /// The level of the next trial, as an index into the factor's levels.
  [[nodiscard]] std::size_t level() const;

  /// A trial was shown at `level`. One without an answer that counts (timed out) is one of the
  /// track's trials, but leaves what the track knows as it was.
  void answer(std::size_t level, std::optional<bool> positive);

  /// What the track knows: its trials so far, then the method's own state, by name.
  [[nodiscard]] std::vector<FactorLevel> state() const;

 private:
  std::variant<StaircaseTrack, QuestPlusTrack> method_;
  std::int64_t trials_{0};
};

/// One track: the levels of the other factors, and where it starts.
struct TrackPlan {
  Condition condition;   ///< without the adaptive factor
  std::size_t start{0};  ///< of a staircase: index of the level it begins at
};

/// The tracks of an adaptive design: every cell of the other factors, and in each every start.
std::vector<TrackPlan> adaptive_tracks(const Design& design);

/// All tracks of a design.
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
  /// Throws std::runtime_error where the plan names a track that the design has not.
  [[nodiscard]] std::size_t place_of_track(const PlannedTrial& trial) const;

  Design design_;
  std::size_t factor_{0};  ///< the adaptive one
  std::vector<AdaptiveTrack> tracks_;
};

/// The trial's level has been chosen.
bool has_its_level(const PlannedTrial& trial, const Design& design);

// A replay derives levels anew from the answers recorded before them, and compares them with what
// was chosen then.

/// An adaptive trial as it was recorded.
struct RecordedLevel {
  std::int64_t trial_id{0};  ///< of the study
  ChosenLevel chosen;
  std::int64_t track{0};
  bool completed{false};
  std::optional<bool> counted_answer{};  ///< none: timed out, or not completed
};

/// Where a derived level or state differs from the recorded one.
struct LevelDivergence {
  std::int64_t trial_id{0};
  std::string words;  ///< "the level chosen was 100, derived anew it is 150"
};

/// One participant's trials, in the order in which their levels were chosen. Of each track the
/// first difference is told: what follows in the track follows from it.
std::vector<LevelDivergence> level_divergences(const Design& design,
                                               const std::vector<RecordedLevel>& recorded);

}  // namespace impetus::inline design
