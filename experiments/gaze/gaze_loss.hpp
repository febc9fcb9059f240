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
#include "experiments/record/script.hpp"

namespace impetus::inline gaze {

/// What `AttemptRecord::interrupted_by` says of a trial that is shown again for it.
inline constexpr const char* kGazeLostNote = "gaze lost";

/// A valid sample tells no longer than this where the eye is, when none follows.
inline constexpr std::int64_t kGazeHolds_ns = 100'000'000;

/// Share of the time from `from_ns` to `until_ns` without a valid sample, from 0 to 1; none when no
/// time has gone by. `samples` in order of time.
std::optional<double> gaze_lost_share(const std::vector<GazeSample>& samples, std::int64_t from_ns,
                                      std::int64_t until_ns);

/// Whether the script's rule finds this share too much; never where it keeps every trial.
bool gaze_was_lost(const Script& script, std::optional<double> lost_share);

/// How often a trial may be shown again for it.
std::int64_t most_repeats(const Script& script);

}  // namespace impetus::inline gaze
