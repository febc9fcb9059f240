// A bank card and a ruler drawn at life size, to be held against real ones.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/viewers/screen_measures.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// Draws both between the corners, in the size that `pixels` implies; what does not fit is cut off
/// at the corners.
void draw_card_and_ruler(const Gui& gui, ImVec2 from, ImVec2 to, const PixelsPerMetre& pixels);

}  // namespace impetus::inline viewers
