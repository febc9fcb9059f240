// What is drawn on the window now, before its flip.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/picture_map.hpp"
#include "experiments/window/png_file.hpp"

namespace impetus::inline window {

/// Of the area, row by row from the top. Needs a current OpenGL 3.3 context.
Pixels window_pixels(const PixelArea& area);

}  // namespace impetus::inline window
