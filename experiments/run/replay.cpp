// SPDX-License-Identifier: MIT
#include "experiments/run/replay.hpp"

#include <utility>

namespace impetus::inline run {

std::optional<Divergence> divergence_of(const StepRecord& recorded, const StateHash& actual,
                                        const World& world,
                                        const std::optional<Divergence>& known) {
  if (actual.hash == recorded.state.hash) {
    return known;
  }
  Divergence divergence = known.value_or(Divergence{recorded.step, "", "", recorded.step});
  const auto difference = first_difference(recorded.state.bodies, actual.bodies);
  if (divergence.body.empty() && difference) {
    divergence.body = world.models()[difference->body].name;
    divergence.field = name_of(difference->field);
    divergence.named_at = recorded.step;
  }
  return divergence;
}

RunningReplay::RunningReplay(StagedScene scene, const std::vector<StepRecord>& recorded)
    : run_(std::move(scene)), recorded_(&recorded) {
  start_.state = hash_state(run_.world().states());
}

const StepReport& RunningReplay::next() {
  const StepRecord& then = (*recorded_)[next_++];
  const StepReport* now = &start_;
  if (then.step != 0) {
    FixedWork meter(grants_of(then));
    now = &run_.step(then.gaze.fixation, then.gaze.region, meter);
    ++result_.steps;
  }
  for (const NotFiniteBody& found : now->not_finite) {
    result_.taken_out.push_back({then.step,
                                 run_.world().models()[static_cast<std::size_t>(found.body)].name,
                                 std::string(name_of(found.field))});
  }
  result_.ends_s = run_.ends_s();
  result_.divergence = divergence_of(then, now->state, run_.world(), result_.divergence);
  return *now;
}

ReplayResult replay(StagedScene scene, const std::vector<StepRecord>& recorded,
                    const StepWatcher& watcher) {
  RunningReplay running(std::move(scene), recorded);
  const auto is_named = [&] {
    return running.result().divergence && !running.result().divergence->body.empty();
  };
  while (!running.done() && (watcher || !is_named())) {
    const std::int64_t step = running.next_step();
    const StepReport& report = running.next();
    if (watcher) {
      watcher(step, running.scene().world, report);
    }
  }
  return running.result();
}

}  // namespace impetus::inline run
