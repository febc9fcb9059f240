// Shows a volume tree in a window: its levels one by one, the mesh through them.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/tree_painter.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline viewers {

/// Until Esc or the window's close; starts with `look`.
void view_tree(Window& window, const ShownTree& shown, const TreeLook& look);

}  // namespace impetus::inline viewers
