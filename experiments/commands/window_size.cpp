// SPDX-License-Identifier: MIT
#include "experiments/commands/window_size.hpp"

#include <cstdio>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

WindowOptions window_options(const std::string& size) {
  WindowOptions options;
  if (size.empty()) {
    return options;
  }
  options.fullscreen = false;
  char rest = '\0';
  const int read =
      std::sscanf(size.c_str(), "%dx%d%c", &options.width_px, &options.height_px, &rest);
  if (read != 2 || options.width_px < 640 || options.height_px < 480) {
    throw InputError("--window " + size + ": expected WIDTHxHEIGHT of at least 640x480 pixels");
  }
  return options;
}

DisplayMode shown_mode(const WindowOptions& window) {
  DisplayMode mode = display_mode();
  if (!window.fullscreen) {
    mode.width_px = window.width_px;
    mode.height_px = window.height_px;
  }
  return mode;
}

}  // namespace impetus::inline commands
