// A small map of the screen: points that were looked at, and where the gaze was.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// Draws from the cursor down, and moves it below; nothing without points.
void draw_point_map(const Gui& gui, const PointMap& map);

}  // namespace impetus::inline window
