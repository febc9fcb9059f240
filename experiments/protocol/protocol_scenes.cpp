// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_scenes.hpp"

#include <algorithm>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

bool is_of_engine(const std::string& pointer) { return pointer.starts_with("/engine"); }

/// The part of the scene that decides levels: the rest may hold whole meshes, and is not copied.
class Engine {
 public:
  explicit Engine(const json& scene) : scene_{{"engine", scene["engine"]}} {}

  void put(const std::string& pointer, const json& value) {
    if (is_of_engine(pointer)) {
      scene_[json::json_pointer(pointer)] = value;
    }
  }
  [[nodiscard]] int deepest_level() const { return scenes::deepest_level_of(scene_["engine"]); }

 private:
  json scene_;
};

int deepest_level_under(const Protocol& protocol, const Condition& condition) {
  Engine engine(protocol.scene.value);
  for (const FactorLevel& level : condition) {
    const json values = values_of(*find_factor(protocol.design, level.factor), level.value);
    for (auto value = values.begin(); value != values.end(); ++value) {
      engine.put(value.key(), value.value());
    }
  }
  return engine.deepest_level();
}

/// The cells of the factors that change the engine: of the others any will do.
std::vector<Condition> cells_of_engine(const Protocol& protocol) {
  Design design = protocol.design;
  std::erase_if(design.factors, [](const Factor& factor) {
    const std::vector<std::string> pointers = overridden_by(factor);
    return std::none_of(pointers.begin(), pointers.end(), is_of_engine);
  });
  return cells(design);
}

int deepest_of_demonstrations(const Protocol& protocol) {
  int deepest = 0;
  for (const Demonstration& demonstration : protocol.script.demonstrations) {
    Engine engine(protocol.scene.value);
    for (const auto& [pointer, value] : demonstration.set) {
      engine.put(pointer, to_json(value));
    }
    deepest = std::max(deepest, engine.deepest_level());
  }
  return deepest;
}

}  // namespace

json scene_of(const Protocol& protocol, const PlannedTrial& trial) {
  json scene = scene_under(protocol, trial.condition);
  put_into_scene(trial.solved, scene);
  return scene;
}

std::string start_of(const PlannedTrial& trial) {
  const bool practice = trial.phase == TrialPhase::kPractice;
  return (practice ? "practice/" : "main/") + std::to_string(trial.repetition);
}

int deepest_level_of(const Protocol& protocol) {
  int deepest = deepest_of_demonstrations(protocol);
  const auto look_at = [&](const Condition& condition) {
    for (const Condition& shown : shown_conditions(protocol.script, condition)) {
      deepest = std::max(deepest, deepest_level_under(protocol, shown));
    }
  };
  for (const Condition& cell : cells_of_engine(protocol)) {
    look_at(cell);
  }
  for (const Condition& practised : protocol.design.practice) {
    for (const Condition& condition : in_every_group(practised, protocol.design)) {
      look_at(condition);
    }
  }
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    for (const Condition& condition : in_every_group(beside.condition, protocol.design)) {
      look_at(condition);
    }
  }
  return deepest;
}

StagedScene ProtocolScenes::stage(const PlannedTrial& trial, const ScreenGeometry& screen) const {
  StagedScene staged = staged_from(protocol_->scene, [&] {
    return build_scene(scene_of(*protocol_, trial), screen, round_hold_to_hz_, *shapes_,
                       start_of(trial), trial.seed, deepest_level_);
  });
  staged.condition = trial.condition;
  const auto& gaze = protocol_->script.gaze;
  staged.gaze_latency_s += gaze ? gaze->extra_latency_ms / 1e3 : 0.0;
  return staged;
}

StagedScene ProtocolScenes::stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const {
  const std::vector<Demonstration>& all = protocol_->script.demonstrations;
  const auto shown =
      std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.id == id; });
  return staged_from(protocol_->scene, [&] {
    return build_scene(demonstration_scene(*protocol_, *shown), screen, round_hold_to_hz_, *shapes_,
                       "demonstration", /*seed=*/1, deepest_level_);
  });
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
  for (const ConditionBeside& beside : conditions_beside(protocol_->design)) {
    for (const Condition& condition : in_every_group(beside.condition, protocol_->design)) {
      static_cast<void>(stage(condition, screen));
    }
  }
  for (const Demonstration& demonstration : protocol_->script.demonstrations) {
    static_cast<void>(stage_demonstration(demonstration.id, screen));
  }
}

}  // namespace impetus::inline protocol
