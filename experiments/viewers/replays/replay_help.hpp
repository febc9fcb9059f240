// All keys of the viewer of replays, over everything else.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws into the current ImGui window.
void draw_replay_help(const Gui& gui);

}  // namespace impetus::inline viewers
