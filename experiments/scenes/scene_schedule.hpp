// The engine part of a scene: schedule, region of high priority, budget.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/scenes/scene_checks.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// The schedule that `engine` asks for: one list to the finest level, or to `level`, when it asks
/// for none. Precondition: schedule_problems() is empty.
Schedule schedule_of(const nlohmann::json& engine);

/// The region that `engine` asks for; kNone when its scheduler is another.
RegionRule region_of(const nlohmann::json& engine);

WorkBudget budget_of(const nlohmann::json& engine);

/// Whether the gaze decides the detail of collisions.
bool depends_on_gaze(const nlohmann::json& engine);

/// What is wrong with the engine part beyond the schema.
std::vector<SceneProblem> schedule_problems(const nlohmann::json& engine);

}  // namespace impetus
