// Colours of which no two alike stand side by side.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// One thing after the other takes the colour whose nearest bearer so far is farthest from it; of
/// several that nobody bears yet, its own if it is among them, or else the first.
void colour_apart(const Scene& scene, StagedScene& staged);

}  // namespace impetus::inline scenes
