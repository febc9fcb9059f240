// From what a scene says of its looks to what painters need.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_problems.hpp"

namespace impetus::inline scenes {

/// Gives the staged scene its appearance and its bodies' colours; the world stays as it is. A scene
/// whose looks are the usual ones gets no appearance, and is painted plainly.
void apply_appearance(const Scene& scene, double metres_per_degree, StagedScene& staged);

void add_appearance_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
