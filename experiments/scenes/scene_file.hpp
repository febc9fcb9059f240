// A scene's JSON and the world it becomes.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/scenes/shape_library.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// The scene's JSON Schema (stimuli/scene.schema.json), as built into the program.
const nlohmann::json& scene_schema();

/// Values that must be whole numbers of the display's frames, by JSON Pointer, and the seconds in
/// their unit. An imposed hold may be rounded to the grid where that is allowed; a lead may not.
struct FrameBoundValue {
  std::string pointer;
  double unit_s;
  bool may_round;
};
const std::vector<FrameBoundValue>& frame_bound_values();

/// What the schema cannot say: one message per broken rule, each with its JSON Pointer.
struct SceneProblem {
  std::string pointer;
  std::string message;  ///< "expected ..., got ..."
};
std::vector<SceneProblem> scene_problems(const nlohmann::json& scene);

/// Builds the scene for a screen, with shapes from `library`. `round_hold_to_hz` > 0 rounds an
/// imposed hold to whole frames of that rate. Precondition: `scene` is valid by schema and
/// scene_problems() is empty.
StagedScene build_scene(const nlohmann::json& scene, const ScreenGeometry& screen,
                        double round_hold_to_hz, ShapeLibrary& library);

}  // namespace impetus
