// Where the researcher enters the screen's size and distance, and checks them by a bank card.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/lab_screen.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline viewers {

/// Asks for width, height and viewing distance, starting from `initial` (metres; 0: empty), and
/// where pixels come out not square, whether they really are so. Returns nothing when cancelled or
/// when the display closes. Pixels are the window's.
std::optional<LabScreen> ask_screen(Window& window, const LabScreen& initial);

}  // namespace impetus::inline viewers
