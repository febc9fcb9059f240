// What a scene's "engine" must fulfil beyond its schema: rules across its settings.
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// Of level and schedule: levels that the trees have, and the keys that belong to the scheduler;
/// then what the engine itself says against the schedule.
void add_schedule_problems(const EngineSettings& engine, SceneProblems& problems);

/// Of region and its scheduler together.
void add_region_problems(const EngineSettings& engine, SceneProblems& problems);

/// Of materials, each of which something has, and of the budget.
void add_material_problems(const Scene& scene, SceneProblems& problems);
void add_budget_problems(const EngineSettings& engine, SceneProblems& problems);

/// Of tree and tree_depth together.
void add_tree_problems(const EngineSettings& engine, SceneProblems& problems);

/// The materials that the scene's bodies, figures, crowd and enclosure name.
std::set<std::string> materials_of(const Scene& scene);

}  // namespace impetus::inline scenes
