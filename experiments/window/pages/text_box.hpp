// A box to type some lines in. ImGui edits what is read from the left alone: what is read from the
// right is edited by it unseen, and drawn over it as it is read.
//
//   typed ─> ImGui: text, caret, selection ─from the left─> drawn by ImGui
//                                          └from the right─> visual_line() ─> drawn over it
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// At the cursor. Lines are broken by the box; `from_right` is where a text without letters begins.
void draw_text_box(std::string& text, ImVec2 size_px, bool from_right);

}  // namespace impetus::inline window
