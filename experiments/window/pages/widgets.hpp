// The few things that every screen of this room is made of: text, buttons, a focus ring.
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <limits>
#include <string>

#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline window {

enum class Align { kLeft, kCentre, kRight };

/// Wrapped text at the cursor, each line aligned within `width_px`; the cursor moves below it.
/// Returns the height.
float draw_text(const std::string& text, ImFont* font, ImU32 colour, float width_px, Align align);

struct ButtonLook {
  std::string label;
  std::string hint;  ///< the key, in a quieter colour after the label; may be empty
  ImVec2 size_px;
  bool focused{false};
  bool chosen{false};  ///< drawn as pressed
};

/// The size that a label and its hint ask for: one line, or as many as the widest button needs.
ImVec2 button_size(const std::string& label, const std::string& hint,
                   float widest_px = std::numeric_limits<float>::max());

/// A button at the cursor; words that are too long for it are broken into lines where its height
/// has room. Returns true when it was clicked with the mouse. `id` sets it apart from the others on
/// the screen.
bool draw_button(int id, const ButtonLook& look);

/// Until ImGui::PopClipRect(), nothing is drawn outside the area.
void push_clip_rect(const PixelArea& area, float window_height_px);

/// A ring around the focused thing.
void draw_focus_ring(ImVec2 from, ImVec2 to);

}  // namespace impetus::inline window
