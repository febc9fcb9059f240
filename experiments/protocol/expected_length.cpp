// SPDX-License-Identifier: MIT
#include "experiments/protocol/expected_length.hpp"

#include <algorithm>
#include <limits>

#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/intervals.hpp"

namespace impetus {

StimulusLength stimulus_length(const Protocol& protocol) {
  const ProtocolScenes scenes(protocol, 0.0);
  StimulusLength length{std::numeric_limits<double>::infinity(), 0.0};
  for (const Condition& cell : cells(protocol.design)) {
    const double duration_s = scenes.stage(cell, assumed_screen()).duration_s;
    length.shortest_s = std::min(length.shortest_s, duration_s);
    length.longest_s = std::max(length.longest_s, duration_s);
  }
  return length;
}

double expected_minutes(const Protocol& protocol, const Plan& plan) {
  const ProtocolScenes scenes(protocol, 0.0);
  double seconds = kAssumedReading_s;
  for (const PlannedTrial& trial : plan) {
    if (trial.phase == TrialPhase::kPractice && trial.repetition > 1) {
      continue;  // most need one round
    }
    seconds += kAssumedAnswer_s + protocol.script.timing.interval_ms / 1e3;
    for (const PlannedTrial& shown : stimuli_of(protocol.script, trial)) {
      seconds += scenes.stage(shown.condition, assumed_screen()).duration_s +
                 protocol.script.timing.fixation_ms / 1e3;
    }
  }
  return seconds / 60.0;
}

}  // namespace impetus
