// What of a scene lies beyond the engine's limits (engine/dynamics/limits.hpp).
//
// Those of places, speeds, spins of bodies and steps are not asked: the schema keeps within them.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// Each with its limit and what was there, in metres, kilograms and seconds. Precondition: the
/// scene is valid by the schema, and its shapes are solids.
std::vector<SceneProblem> limit_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
