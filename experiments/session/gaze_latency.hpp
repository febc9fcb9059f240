// How long a gaze sample took to reach the screen, judged.
//
//   sample ── age ──> step computed ── drawn ──> flip      latency = flip − sample
//
// ≤ 60 ms is good; > 70 ms warns; > 80 ms marks the trial. (Loschky and Wolverton 2007 found no
// detection of the change up to 60 ms)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/session/record.hpp"

namespace impetus {

inline constexpr double kWarnedGazeLatency_ms = 70.0;
inline constexpr double kMarkedGazeLatency_ms = 80.0;

/// The 95th percentile (nearest rank) over the steps that knew the gaze and were shown; none
/// without such a step.
std::optional<double> gaze_latency_p95_ms(const std::vector<StepRecord>& steps,
                                          const std::vector<FrameRecord>& frames);

}  // namespace impetus
