// The goal of a scene: a line that a body may cross.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// As the world has it; none where the scene has none. Precondition: add_goal_problems() adds none.
std::optional<Goal> goal_of(const Scene& scene, double metres_per_degree);

/// Adds what is wrong with it: it needs a plane, a body that moves, and bodies that there are.
void add_goal_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
