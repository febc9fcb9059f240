// How long a gaze sample took to reach the screen, judged.
//
//   sample ── age ──> step computed ── drawn ──> flip      latency = flip − sample
//
//   samples   . . . u x x x x . .      u: the one used, x: lost
//   steps           1    2      3      1 and 3 count, 2 does not
//
// Loss of the eye is not latency: in a blink the last sample ages, however fast the machine. So a
// step counts only while nothing newer than its sample had been lost; when samples stop coming
// altogether, it does count. What was lost is told by the samples, how old a step's sample was by
// the step.
//
// ≤ 60 ms is good; > 70 ms warns; > 80 ms marks the trial. (Loschky and Wolverton 2007 found no
// detection of the change up to 60 ms)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline gaze {

inline constexpr double kWarnedGazeLatency_ms = 70.0;
inline constexpr double kMarkedGazeLatency_ms = 80.0;

/// From sample to flip, over the steps that knew the gaze, were shown, and whose sample was not
/// followed by a lost one taken before the step, in order. `samples` in order of time; `frames` by
/// their number.
std::vector<double> gaze_latencies_ms(const std::vector<StepRecord>& steps,
                                      const std::vector<FrameRecord>& frames,
                                      const std::vector<GazeSample>& samples);

/// Their 95th percentile (nearest rank); none without such a step.
std::optional<double> gaze_latency_p95_ms(const std::vector<StepRecord>& steps,
                                          const std::vector<FrameRecord>& frames,
                                          const std::vector<GazeSample>& samples);

}  // namespace impetus::inline gaze
