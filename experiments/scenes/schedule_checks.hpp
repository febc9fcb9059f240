// What the parts of a scene's schedule must fulfil before the engine is asked: levels that the
// trees have, and the keys that belong to its scheduler.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// Of `level` and of the lists' levels: they exist, and in order.
void add_level_problems(const nlohmann::json& engine, std::vector<SceneProblem>& problems);

/// Of thresholds or shares as many as the lists need, terms and a point only with the scheduler
/// that takes them, whole steps of persistence. Precondition: `engine` has a schedule.
void add_schedule_key_problems(const nlohmann::json& engine, std::vector<SceneProblem>& problems);

}  // namespace impetus::inline scenes
