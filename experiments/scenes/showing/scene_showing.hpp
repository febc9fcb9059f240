// What of a scene is shown, in its world.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// Of a scene whose bodies meet after a hold of `hold_s`, or not at all: when its stimulus begins
/// to move and ends, what is hidden after that, and who flashes. Precondition: the scene's bodies
/// are there, and add_showing_problems() adds none.
void apply_showing(const Scene& scene, double hold_s, StagedScene& staged);

/// Adds what is wrong with it: it is still for whole steps, what flashes is there, and what is
/// hidden would have been shown.
void add_showing_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
