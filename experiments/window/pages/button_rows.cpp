// SPDX-License-Identifier: MIT
#include "experiments/window/pages/button_rows.hpp"

#include <algorithm>

namespace impetus::inline window {

ButtonRows::ButtonRows(float width_px, float gap_px)
    : origin_(ImGui::GetCursorScreenPos()), width_px_(width_px), gap_px_(gap_px), at_(origin_) {}

void ButtonRows::place(ImVec2 size_px) {
  if (at_.x > origin_.x && at_.x + size_px.x > origin_.x + width_px_) {
    at_ = ImVec2(origin_.x, at_.y + row_px_ + gap_px_);
    row_px_ = 0.0F;
  }
  ImGui::SetCursorScreenPos(at_);
  at_.x += size_px.x + gap_px_;
  row_px_ = std::max(row_px_, size_px.y);
}

void ButtonRows::end() const { ImGui::SetCursorScreenPos(ImVec2(origin_.x, at_.y + row_px_)); }

}  // namespace impetus::inline window
