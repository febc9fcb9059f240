// The plane of a scene, whose pixels its bodies may be said in.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// Adds what is said in pixels without a plane, or in degrees as well.
void add_plane_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
