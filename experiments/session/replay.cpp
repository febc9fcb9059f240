// SPDX-License-Identifier: MIT
#include "experiments/session/replay.hpp"

#include <utility>

namespace impetus {
namespace {

/// What is known of a divergence once this step's hash differs.
Divergence locate(const std::optional<Divergence>& known, const StepRecord& recorded,
                  const StateHash& actual, const std::vector<BodyModel>& models) {
  Divergence divergence = known.value_or(Divergence{recorded.step, "", "", recorded.step});
  const auto difference = first_difference(recorded.state.bodies, actual.bodies);
  if (divergence.body.empty() && difference) {
    divergence.body = models[difference->body].name;
    divergence.field = name_of(difference->field);
    divergence.named_at = recorded.step;
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
    if (now->state.hash != then.state.hash) {
      result.divergence = locate(result.divergence, then, now->state, scene.world.models());
    }
    if (watcher) {
      watcher(then.step, scene.world, *now);
    } else if (result.divergence && !result.divergence->body.empty()) {
      return result;
    }
  }
  return result;
}

}  // namespace impetus
