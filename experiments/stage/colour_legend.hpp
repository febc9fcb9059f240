// What colours mean, written into a corner of the picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/stage/body_colours.hpp"
#include "experiments/stage/gui.hpp"
#include "experiments/stage/pixel_area.hpp"

namespace impetus {

/// Draws into the current ImGui window, in the lower left corner of the area; nothing where there
/// is nothing to tell. `note` is a last line without a colour; "": none.
void draw_colour_legend(const Gui& gui, const PixelArea& area,
                        const std::vector<ColourMeaning>& meanings, const std::string& note = "");

}  // namespace impetus
