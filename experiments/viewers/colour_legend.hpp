// What colours mean, written into a corner of the picture.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/body_colours.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws into the current ImGui window, in the lower left corner of the area; nothing where there
/// is nothing to tell. `note` is a last line without a colour; "": none.
void draw_colour_legend(const Gui& gui, const PixelArea& area,
                        const std::vector<ColourMeaning>& meanings, const std::string& note = "");

/// The same in as few lines as it can along the area's lower edge, so that it covers little.
void draw_colour_line(const Gui& gui, const PixelArea& area,
                      const std::vector<ColourMeaning>& meanings);

}  // namespace impetus::inline viewers
