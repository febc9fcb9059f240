// Shows a volume tree: in a window, its levels one by one, the mesh through them; or as pictures,
// for figures and on machines without a display.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/drawing/tree_painter.hpp"
#include "experiments/window/pixels.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline viewers {

/// Until Esc or the window's close; starts with `look`.
void view_tree(Window& window, const ShownTree& shown, const TreeLook& look);

/// One picture for each look, on a white ground. Throws std::runtime_error with one sentence when
/// no OpenGL 3.3 can be had.
std::vector<Pixels> pictures_of(const ShownTree& shown, const std::vector<TreeLook>& looks,
                                const PictureSize& size);

}  // namespace impetus::inline viewers
