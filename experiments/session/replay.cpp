// SPDX-License-Identifier: MIT
#include "experiments/session/replay.hpp"

#include <utility>

namespace impetus {
namespace {

Divergence locate(const StepRecord& recorded, const StateHash& actual,
                  const std::vector<BodyModel>& models) {
  Divergence divergence{recorded.step, "", ""};
  if (const auto difference = first_difference(recorded.state.bodies, actual.bodies)) {
    divergence.body = models[difference->body].name;
    divergence.field = name_of(difference->field);
  }
  return divergence;
}

}  // namespace

ReplayResult replay(StagedScene scene, const std::vector<StepRecord>& recorded, bool keep_states) {
  ReplayResult result;
  const StepInput input{1.0 / scene.step_hz, scene.viewer};
  for (const StepRecord& then : recorded) {
    StateHash now;
    if (then.step == 0) {
      now = hash_state(scene.world.states());
    } else {
      FixedWork meter(then.work_granted);
      now = scene.world.step(input, meter).state;
      ++result.steps;
    }
    if (now.hash != then.state.hash && !result.divergence) {
      result.divergence = locate(then, now, scene.world.models());
    }
    if (result.divergence && !keep_states) {
      return result;
    }
    if (keep_states) {
      result.states.push_back(scene.world.states());
    }
  }
  return result;
}

}  // namespace impetus
