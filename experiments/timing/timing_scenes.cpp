// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_scenes.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/scenes/scene_file.hpp"
#include "experiments/timing/embedded_creatures.hpp"
#include "experiments/timing/embedded_l_blocks.hpp"

namespace impetus::inline timing {
namespace {

constexpr int kMostBlocks = 100;

}  // namespace

PlannedTrial timing_trial(int bodies) {
  PlannedTrial trial;
  trial.slot = bodies;
  trial.condition = {{"bodies", static_cast<double>(bodies)}};
  trial.seed = 1;
  return trial;
}

StagedScene TimingScenes::stage(const PlannedTrial& trial, const ScreenGeometry& screen) const {
  const bool crowd = trial.slot > kMostBlocks;
  nlohmann::json scene = nlohmann::json::parse(crowd ? kCreaturesSceneText : kLBlocksSceneText);
  scene["crowd"]["count"] = trial.slot;
  scene["duration_s"] = duration_s_;
  if (!crowd) {
    scene["engine"]["region"]["kind"] = "tracked";
  }
  return build_scene(scene, screen, kUnroundedHold, *shapes_, "timing", trial.seed);
}

StagedScene TimingScenes::stage_demonstration(const std::string& id,
                                              const ScreenGeometry& /*screen*/) const {
  throw std::logic_error("a timing report has no demonstration " + id);
}

}  // namespace impetus::inline timing
