// Scenes for previews without a window.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/engine/builders.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/places/places.hpp"

namespace impetus {

inline constexpr int kDepth = 3;
inline constexpr double kFrame_s = 1.0 / 60.0;

inline StagedScene crowd(Schedule schedule = {}) {
  constexpr int kBodies = 27;
  Viewer viewer = step_of(kStep_s).viewer;
  viewer.screen = {0.376, 0.301, 1280, 1024, 10.0};
  return {enclosed_l_blocks(kBodies, kDepth, std::move(schedule)), viewer,
          std::vector<DrawnBody>(kBodies)};
}

inline StagedScene two_l_blocks() {
  const JsonDocument scene =
      load_scene(std::filesystem::path(source_folder()) / "stimuli/two-l-blocks.json");
  ShapeLibrary shapes;
  return build_scene(scene.value, assumed_screen(), 0.0, shapes);
}

inline StagedScene cube() {
  const JsonDocument scene =
      load_scene(std::filesystem::path(source_folder()) / "stimuli/l-blocks-in-a-cube.json");
  ShapeLibrary shapes;
  return build_scene(scene.value, assumed_screen(), 0.0, shapes);
}

}  // namespace impetus
