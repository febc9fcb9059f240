// Scenes of growing demand, from two spheres to a crowd, and what a step of each is told.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"

namespace impetus {

struct DemandScene {
  std::string name;
  StagedScene staged;
};

/// Steps of one run through the scene, after which it starts anew.
inline std::int64_t steps_of_a_run(const DemandScene& scene) {
  return std::llround(scene.staged.duration_s * scene.staged.step_hz);
}

/// What the step is told: a gaze that goes round at 4° from the centre, once in four seconds, with
/// a region about it where the scene follows one.
inline StepInput input_of_step(const DemandScene& scene, std::int64_t step) {
  constexpr double kAside_deg = 4.0;
  constexpr double kRound_s = 4.0;
  constexpr double kTurn_rad = 6.283185307179586;
  const double time_s = static_cast<double>(step) / scene.staged.step_hz;
  const double aside_m =
      kAside_deg * metres_per_degree(scene.staged.viewer.screen.viewing_distance_m);
  const double angle_rad = kTurn_rad * time_s / kRound_s;
  const ScreenPoint gaze{aside_m * std::cos(angle_rad), aside_m * std::sin(angle_rad)};
  StepInput input{1.0 / scene.staged.step_hz, scene.staged.viewer};
  if (scene.staged.depends_on_gaze) {
    input.fixation = gaze;
  }
  if (scene.staged.region.kind == RegionKind::kTracked) {
    input.region = GazeRegion{gaze, scene.staged.region.radius_deg};
  }
  return input;
}

/// Each asks for more than the one before. `stimuli` is the folder of the scenes' files.
inline std::vector<DemandScene> scenes_of_growing_demand(const std::filesystem::path& stimuli,
                                                         ShapeLibrary& library) {
  nlohmann::json gaze = load_scene(stimuli / "l-blocks-in-a-cube.json").value;
  gaze["engine"]["region"]["kind"] = "tracked";
  gaze["crowd"]["count"] = 15;
  const std::vector<std::pair<std::string, nlohmann::json>> scenes{
      {"two spheres", load_scene(stimuli / "two-spheres.json").value},
      {"two L-blocks", load_scene(stimuli / "two-l-blocks.json").value},
      {"80 spheres in view", load_scene(stimuli / "spheres-in-view.json").value},
      {"15 L-blocks with gaze", std::move(gaze)},
      {"250 creatures", load_scene(stimuli / "creatures-in-a-cube.json").value}};
  std::vector<DemandScene> result;
  for (const auto& [name, scene] : scenes) {
    result.push_back({name, build_scene(scene, assumed_screen(), 0.0, library)});
  }
  return result;
}

}  // namespace impetus
