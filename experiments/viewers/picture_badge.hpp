// Words in the upper left corner of a picture, legible on whatever is there.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/drawing/picture_map.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws into the current ImGui window; nothing for "".
void draw_badge(const Gui& gui, const PixelArea& area, const std::string& words);

}  // namespace impetus::inline viewers
