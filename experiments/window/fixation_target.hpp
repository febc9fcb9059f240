// A point that is easy to look at: a dark disc, a light cross through it, a dark dot in its middle.
//
// Of seven shapes this one let the eye rest most. (Thaler et al. 2013)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/viewer.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// Draws within the present frame, which fills the window that is `screen`.
void draw_fixation_target(const Gui& gui, const ScreenGeometry& screen, const ScreenPoint& at);

}  // namespace impetus::inline window
