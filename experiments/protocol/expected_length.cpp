// SPDX-License-Identifier: MIT
#include "experiments/protocol/expected_length.hpp"

#include <algorithm>
#include <limits>

#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline protocol {
namespace {

double duration_under(const Protocol& protocol, const Condition& condition) {
  const Scene scene = scene_under(protocol, condition);
  return scene.lasting_s(scene.intended_hold_s());
}

}  // namespace

StimulusLength stimulus_length(const Protocol& protocol) {
  StimulusLength length{std::numeric_limits<double>::infinity(), 0.0};
  for (const Condition& cell : cells(protocol.design)) {
    const double duration_s = duration_under(protocol, cell);
    length.shortest_s = std::min(length.shortest_s, duration_s);
    length.longest_s = std::max(length.longest_s, duration_s);
  }
  return length;
}

double expected_minutes(const Protocol& protocol, const Plan& plan) {
  const TwoIntervalQuestion* two = find_two_interval(protocol.script);
  const Questions& asked = protocol.script.asked;
  const auto answers = std::max(
      1.0, static_cast<double>(std::count_if(asked.begin(), asked.end(), [](const auto& question) {
        return !question->kind().during_stimulus;
      })));
  double seconds = kAssumedReading_s;
  for (const PlannedTrial& trial : plan) {
    if (trial.is_practice() && trial.repetition > 1) {
      continue;  // most need one round
    }
    if (!trial.is_asked()) {
      seconds += duration_under(protocol, trial.condition) +
                 protocol.script.timing.between_adaptors_ms / 1e3;
      continue;
    }
    seconds += answers * kAssumedAnswer_s + protocol.script.timing.interval_ms / 1e3 +
               (two != nullptr ? two->between_ms() / 1e3 : 0.0);
    for (const PlannedTrial& shown : stimuli_of(protocol.script, trial)) {
      const FixationTime& cross = protocol.script.timing.fixation;
      seconds +=
          duration_under(protocol, shown.condition) + 0.5 * (cross.least_ms + cross.most_ms) / 1e3;
    }
  }
  return seconds / 60.0;
}

}  // namespace impetus::inline protocol
