// Shows a scene that runs on and on, with a panel that changes its schedule while it runs.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/ports.hpp"
#include "experiments/session/staged_scene.hpp"
#include "experiments/stage/window.hpp"

namespace impetus {

/// Runs the scene in real time until Esc or the window's close. `clock` is the window's.
void view_preview(Window& window, StagedScene scene, const Clock& clock);

}  // namespace impetus
