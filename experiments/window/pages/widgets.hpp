// The few things that every screen of this room is made of: text, buttons in rows, a focus ring.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/drawing/palette.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// From the top of one line to the top of the next, in pixels.
float line_height(const ImFont& font);

/// The lines, broken between words, or within one that is longer than a line. They look into
/// `text`, which must outlive them.
std::vector<std::string_view> lines_of(const std::string& text, const ImFont& font, float width_px);

/// The width of a text on one line, in pixels.
float width_of(std::string_view text, const ImFont& font);

/// Writes a text from its upper left corner on, in whole pixels or not.
void write_at(ImVec2 corner, std::string_view text, ImFont* font, ImU32 colour);

/// Where lines stand in their column: at its left, in its middle, at its right; or at the side from
/// which the text is read.
enum class Align { kLeft, kCentre, kRight, kStart };

/// Wrapped text at the cursor, each line aligned within `width_px`; the cursor moves below it.
/// Returns the height.
float draw_text(const std::string& text, ImFont* font, ImU32 colour, float width_px, Align align);

/// A button as it is to be drawn.
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

/// The ground of what lies over everything else, in the middle of the window; its upper left
/// corner.
ImVec2 draw_card(const Gui& gui, ImVec2 size_px);

/// A ring around the focused thing.
void draw_focus_ring(ImVec2 from, ImVec2 to);

/// Where buttons go that stand in rows, as many beside each other as a width holds.
class ButtonRows {
 public:
  /// The first row begins at the cursor; the first button of a row is at its right where rows are
  /// read from the right.
  ButtonRows(float width_px, float gap_px, bool from_right = false)
      : width_px_(width_px), gap_px_(gap_px), from_right_(from_right) {}

  /// Moves the cursor to where the next button goes, which is of this size.
  void place(ImVec2 size_px);

  /// Moves the cursor to the left edge below the last row.
  void end() const { ImGui::SetCursorScreenPos(ImVec2(origin_.x, at_.y + row_px_)); }

 private:
  float width_px_;
  float gap_px_;
  bool from_right_;
  ImVec2 origin_{ImGui::GetCursorScreenPos()};
  ImVec2 at_{origin_};
  float row_px_{0.0F};  ///< as high as the highest button of the row
};

}  // namespace impetus::inline window
