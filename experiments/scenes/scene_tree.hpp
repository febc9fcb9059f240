// The volume trees that a scene's bodies have.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "engine/trees/tree_settings.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// What `engine` asks for with tree and tree_depth: an octree of the root alone when it says
/// nothing; not built beyond `deepest_level`. Precondition: `engine` is valid by the scene's
/// schema.
TreeSettings tree_settings_of(const nlohmann::json& engine, int deepest_level = kGreatestTreeDepth);

/// Adds what is wrong with tree and tree_depth together. The same precondition.
void add_tree_problems(const nlohmann::json& engine, std::vector<SceneProblem>& problems);

}  // namespace impetus::inline scenes
