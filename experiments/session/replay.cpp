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

ReplayResult replay(StagedScene scene, const std::vector<StepRecord>& recorded,
                    const StepWatcher& watcher) {
  ReplayResult result;
  StepReport start;
  start.state = hash_state(scene.world.states());
  for (const StepRecord& then : recorded) {
    const StepReport* now = &start;
    if (then.step != 0) {
      FixedWork meter(then.work_granted);
      const double time_s = static_cast<double>(then.step) / scene.step_hz;
      const StepInput input{1.0 / scene.step_hz, scene.viewer_at_time(time_s), then.gaze.fixation,
                            then.gaze.region};
      now = &scene.world.step(input, meter);
      ++result.steps;
    }
    for (const NotFiniteBody& found : now->not_finite) {
      result.taken_out.push_back({then.step,
                                  scene.world.models()[static_cast<std::size_t>(found.body)].name,
                                  std::string(name_of(found.field))});
    }
    if (now->state.hash != then.state.hash && !result.divergence) {
      result.divergence = locate(then, now->state, scene.world.models());
    }
    if (watcher) {
      watcher(then.step, scene.world, *now);
    } else if (result.divergence) {
      return result;
    }
  }
  return result;
}

}  // namespace impetus
