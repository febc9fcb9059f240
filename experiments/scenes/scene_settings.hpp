// The rest of a scene's engine part: contacts, fast bodies, response, materials and budget.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// What `scene` says of the world's settings, as the engine has them where it says nothing; holds,
/// enclosure and schedule apart. Precondition: engine_problems() is empty.
WorldSettings engine_settings_of(const nlohmann::json& scene);

/// The number of a material by its name: those of the scene, in alphabetical order, from 1; 0 for
/// `holder` (a body, the crowd or the enclosure) that names none.
int material_of(const nlohmann::json& scene, const nlohmann::json& holder);

WorkBudget budget_of(const nlohmann::json& engine);

/// What is wrong with materials and budget beyond the schema.
std::vector<SceneProblem> engine_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
