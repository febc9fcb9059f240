// A screen that says what is being done and how far it is, while nothing else can be shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/window/canvas.hpp"

namespace impetus::inline window {

/// Draws and flips one frame. `share` from 0 to 1.
void show_wait(Canvas& canvas, const std::string& title, const std::string& doing, double share);

}  // namespace impetus::inline window
