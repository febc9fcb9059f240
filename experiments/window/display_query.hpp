// What can be known of the display before a window opens.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline window {

/// How the display is driven.
struct DisplayMode {
  double refresh_hz{0.0};  ///< nominal; 60 when it does not say
  int width_px{0};
  int height_px{0};
};

/// Throws std::runtime_error with one sentence when there is no display.
DisplayMode display_mode();

}  // namespace impetus::inline window
