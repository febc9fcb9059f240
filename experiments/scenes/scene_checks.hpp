// What a scene must fulfil beyond its schema; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_problems.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline scenes {

/// What is wrong with a scene, in the order in which it is asked. Precondition: `scene` is valid by
/// scene_schema(), and its figures by theirs.
/// `library` builds the scene's shapes, so whoever checks many scenes, or stages this one
/// afterwards, has each built once.
std::vector<SceneProblem> scene_problems(const nlohmann::json& scene, ShapeLibrary& library);
std::vector<SceneProblem> scene_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
