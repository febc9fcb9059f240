// What of a scene lies beyond the engine's limits (engine/dynamics/limits.hpp).
//
// Those of places, speeds, spins of bodies and steps are not asked: the schema keeps within them.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline scenes {

/// Adds each with its limit and what was there, in metres, kilograms and seconds. Precondition: the
/// scene's shapes are solids, which `library` builds.
void add_limit_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems);

}  // namespace impetus::inline scenes
