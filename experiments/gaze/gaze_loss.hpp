// For how much of a stimulus the gaze was lost, and whether that is too much.
//
//   samples   v v x x x v . . . . . v        v: valid, x: lost, .: none came
//   lost            ------    -----          a valid one holds until the next, 100 ms at most
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline gaze {

/// What becomes of a trial in which the gaze was lost for more than a share of the stimulus.
struct GazeLossRule {
  /// It counts as any other, it counts and is marked, or it is shown again.
  enum class Policy { kKeep, kMark, kRepeat };
  double most_lost_share{0.5};
  Policy policy{Policy::kMark};
  std::int64_t most_repeats{2};  ///< of a trial; then it is kept, marked
};

/// What `AttemptRecord::interrupted_by` says of a trial that is shown again for it.
inline constexpr const char* kGazeLostNote = "gaze lost";

/// A valid sample tells no longer than this where the eye is, when none follows.
inline constexpr std::int64_t kGazeHolds_ns = 100'000'000;

/// Share of the time from `from_ns` to `until_ns` without a valid sample, from 0 to 1; none when no
/// time has gone by. `samples` in order of time.
std::optional<double> gaze_lost_share(const std::vector<GazeSample>& samples, std::int64_t from_ns,
                                      std::int64_t until_ns);

/// Whether the rule finds this share too much; never where it keeps every trial, or there is none.
bool gaze_was_lost(const std::optional<GazeLossRule>& rule, std::optional<double> lost_share);

/// How often a trial may be shown again for it.
std::int64_t most_repeats(const std::optional<GazeLossRule>& rule);

}  // namespace impetus::inline gaze
