// How long a participant will sit at a protocol, estimated from its plan.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// A participant's own pace, for the estimate alone.
inline constexpr double kAssumedAnswer_s = 1.5;
inline constexpr double kAssumedReading_s = 150.0;

/// Shortest and longest stimulus of the design's cells, seconds.
struct StimulusLength {
  double shortest_s{0.0};
  double longest_s{0.0};
};
StimulusLength stimulus_length(const Protocol& protocol);

/// Minutes for reading, one round of practice and all main trials of `plan`.
double expected_minutes(const Protocol& protocol, const Plan& plan);

}  // namespace impetus::inline protocol
