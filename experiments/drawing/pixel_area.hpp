// A part of the window.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// A rectangle of the window in pixels, from its lower left corner.
struct PixelArea {
  int left{0};
  int bottom{0};
  int width{0};
  int height{0};
};

}  // namespace impetus::inline drawing
