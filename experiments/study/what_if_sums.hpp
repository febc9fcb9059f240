// Recorded stimuli simulated both ways, and what their two courses come to, counted.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "experiments/record/wall_names.hpp"
#include "experiments/run/what_if.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/replay_library.hpp"

namespace impetus::inline study {

/// One stimulus of one attempt, simulated both ways.
struct ComparedStimulus {
  const StoredAttempt* attempt{nullptr};
  std::int64_t interval{1};
  double step_hz{240.0};
  std::vector<std::string> bodies;  ///< names, by index in the world
  WallNaming walls{WallNaming::kAxes};
  bool has_gaze{false};  ///< a step knew where the participant looked
  WhatIf outcome;
};

/// Of the collisions of one course or of several, and what else is counted.
struct CourseSums {
  std::int64_t collisions{0};
  std::map<int, std::int64_t> by_level;
  double levels{0.0};
  double visible_arcmin{0.0};
  double at_gaze_arcmin{0.0};
  std::int64_t work_spent{0};
  std::int64_t steps_over_budget{0};
  std::int64_t pops{0};
  std::int64_t stopped_short{0};
  std::int64_t imposed_holds{0};
  std::int64_t imposed_spins{0};

  /// Mean over the collisions; not a number without any.
  [[nodiscard]] double mean(double sum) const;

  friend bool operator==(const CourseSums&, const CourseSums&) = default;
};

CourseSums sums_of(const WhatIfCourse& course);

/// How many collisions both simulations have, and how many only one.
struct MatchCounts {
  std::int64_t both{0};
  std::int64_t only_then{0};
  std::int64_t only_now{0};
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MatchCounts, both, only_then, only_now)

MatchCounts counts_of(const WhatIf& outcome);

/// The sums over all stimuli that were compared.
struct WhatIfTotals {
  CourseSums then;
  CourseSums now;
  MatchCounts matches;
  std::int64_t parted{0};
  std::int64_t seen_apart{0};
  bool differs{false};  ///< in any stimulus, in anything
};

WhatIfTotals totals_of(const std::vector<ComparedStimulus>& compared);

/// When a step was; not a number when there is none.
double seconds_of(const std::optional<std::int64_t>& step, double step_hz);

/// Simulates one stimulus of the attempt, which must outlive what is returned, both ways: as it was
/// recorded, and with the library's changed settings.
ComparedStimulus compared(ReplayLibrary& library, const StoredAttempt& attempt,
                          std::int64_t interval);

/// What is told of a course, by the names that all files have, in the order of a table.
std::vector<std::pair<std::string, nlohmann::json>> named_sums(const CourseSums& sums);

nlohmann::json json_of(const CourseSums& sums);

/// With its sums and every collision.
nlohmann::json json_of(const ComparedStimulus& each);

}  // namespace impetus::inline study
