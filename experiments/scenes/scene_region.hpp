// The region of high priority that a scene asks for.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// The scheduler whose lists follow a region.
inline constexpr const char* kRegionScheduler = "region";

/// The region that `engine` asks for; kNone when its scheduler is another.
RegionRule region_of(const nlohmann::json& engine, double metres_per_degree);

/// Adds what is wrong with region and its scheduler together.
void add_region_problems(const nlohmann::json& engine, std::vector<SceneProblem>& problems);

}  // namespace impetus::inline scenes
