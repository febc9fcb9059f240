// Adaptive levels derived anew from the answers recorded before them, and compared with what was
// chosen then.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/adaptive_levels.hpp"

namespace impetus::inline design {

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
