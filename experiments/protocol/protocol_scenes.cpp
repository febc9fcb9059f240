// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_scenes.hpp"

#include "experiments/protocol/trial_scene.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline protocol {
StagedScene ProtocolScenes::stage(const PlannedTrial& trial, const ScreenGeometry& screen) const {
  return build_scene(scene_of(*protocol_, trial), screen, round_hold_to_hz_, *shapes_,
                     start_of(trial), trial.seed, deepest_level_);
}

StagedScene ProtocolScenes::stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const {
  return build_scene(demonstration_scene(*protocol_, id), screen, round_hold_to_hz_, *shapes_,
                     "demonstration", /*seed=*/1, deepest_level_);
}

StagedScene ProtocolScenes::stage(const Condition& condition, const ScreenGeometry& screen) const {
  PlannedTrial trial;
  trial.condition = condition;
  return stage(trial, screen);
}

void ProtocolScenes::build_shapes(const ScreenGeometry& screen) const {
  for (const Condition& cell : cells(protocol_->design)) {
    for (const Condition& shown : shown_conditions(protocol_->script, cell)) {
      static_cast<void>(stage(shown, screen));
    }
  }
  for (const CatchTrials& kind : protocol_->design.catch_trials) {
    static_cast<void>(stage(kind.condition, screen));
  }
  for (const Demonstration& demonstration : protocol_->script.demonstrations) {
    static_cast<void>(stage_demonstration(demonstration.id, screen));
  }
}

}  // namespace impetus::inline protocol
