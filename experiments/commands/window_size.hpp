// The option --window WIDTHxHEIGHT, and how many pixels a window will have.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/window/display.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline commands {

/// Fullscreen for "". Throws InputError for anything but WIDTHxHEIGHT of at least 640x480.
WindowOptions window_options(const std::string& size);

/// The display as such a window will show it, found without opening the window. Throws
/// std::runtime_error when there is no display.
DisplayMode shown_mode(const WindowOptions& window);

}  // namespace impetus::inline commands
