// Pictures of a volume tree without a window to be seen: for figures, and on machines without a
// display.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/drawing/tree_painter.hpp"
#include "experiments/window/png_file.hpp"
#include "experiments/window/readable_target.hpp"

namespace impetus::inline viewers {

/// One picture for each look, on a white ground. Throws std::runtime_error with one sentence when
/// no OpenGL 3.3 can be had.
std::vector<Pixels> pictures_of(const ShownTree& shown, const std::vector<TreeLook>& looks,
                                const PictureSize& size);

}  // namespace impetus::inline viewers
