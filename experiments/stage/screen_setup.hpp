// Where the researcher enters the screen's size and distance, and checks them by a bank card.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/stage/window.hpp"

namespace impetus {

/// Asks for width, height and viewing distance, starting from `initial` (metres; 0: empty).
/// Returns nothing when cancelled or when the display closes. Pixels are the window's.
std::optional<ScreenGeometry> ask_screen_geometry(Window& window, const ScreenGeometry& initial);

}  // namespace impetus
