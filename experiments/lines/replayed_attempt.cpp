// SPDX-License-Identifier: MIT
#include "experiments/lines/replayed_attempt.hpp"

#include <utility>
#include <vector>

#include "experiments/questions/two_interval.hpp"

namespace impetus::inline lines {
namespace {

/// The steps of one interval, taken out of the attempt and put back with their digests.
class IntervalSteps {
 public:
  IntervalSteps(std::vector<StepRecord>& all, std::int64_t interval) {
    for (StepRecord& step : all) {
      if (step.interval == interval) {
        places_.push_back(&step);
        steps_.push_back(step);
      }
    }
  }

  [[nodiscard]] const std::vector<StepRecord>& steps() const { return steps_; }

  void fill_digests(std::size_t at, const std::vector<BodyDigest>& digests) {
    if (places_[at]->state.bodies.empty()) {
      places_[at]->state.bodies = digests;
    }
  }

 private:
  std::vector<StepRecord*> places_;
  std::vector<StepRecord> steps_;
};

}  // namespace

AttemptReplay::AttemptReplay(const Protocol& protocol, const SessionRecord& session,
                             int recording_format)
    : protocol_(protocol),
      screen_(session.screen),
      scenes_(protocol, session.rounding_allowed ? session.refresh_hz : 0.0),
      recording_format_(recording_format) {}

ReplayedAttempt AttemptReplay::replay(const PlannedTrial& trial, AttemptRecord& attempt) const {
  ReplayedAttempt result;
  std::int64_t interval = 0;
  for (const PlannedTrial& stimulus : stimuli_of(protocol_.script, trial)) {
    IntervalSteps recorded(attempt.steps, ++interval);
    if (recorded.steps().empty()) {
      continue;
    }
    StagedScene scene = scenes_.stage(stimulus, screen_);
    scene.world.set_recording_format(recording_format_);
    RunningReplay running(std::move(scene), recorded.steps());
    for (std::size_t at = 0; !running.done(); ++at) {
      recorded.fill_digests(at, running.next().state.bodies);
    }
    result.steps += running.result().steps;
    if (!result.divergence) {
      result.divergence = running.result().divergence;
    }
  }
  return result;
}

std::string divergence_words(std::int64_t trial, const Divergence& divergence) {
  const std::string where =
      "trial " + std::to_string(trial) + ", step " + std::to_string(divergence.step);
  return divergence.body.empty() ? where
                                 : where + ", body " + divergence.body + ", " + divergence.field;
}

}  // namespace impetus::inline lines
