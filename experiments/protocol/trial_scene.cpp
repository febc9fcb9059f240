// SPDX-License-Identifier: MIT
#include "experiments/protocol/trial_scene.hpp"

#include "experiments/protocol/solved_values.hpp"

namespace impetus::inline protocol {

nlohmann::json scene_of(const Protocol& protocol, const PlannedTrial& trial) {
  nlohmann::json scene = scene_under(protocol, trial.condition);
  put_into_scene(trial.solved, scene);
  return scene;
}

std::string start_of(const PlannedTrial& trial) {
  const bool practice = trial.phase == TrialPhase::kPractice;
  return (practice ? "practice/" : "main/") + std::to_string(trial.repetition);
}

}  // namespace impetus::inline protocol
