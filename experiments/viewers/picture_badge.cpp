// SPDX-License-Identifier: MIT
#include "experiments/viewers/picture_badge.hpp"

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {

void draw_badge(const Gui& gui, const PixelArea& area, const std::string& words) {
  if (words.empty()) {
    return;
  }
  ImFont* font = gui.fonts().small;
  const float inset_px = 0.5F * font->FontSize;
  const ImVec2 corner(static_cast<float>(area.left) + inset_px,
                      gui.height() - static_cast<float>(area.bottom + area.height) + inset_px);
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, words.c_str());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner,
                     ImVec2(corner.x + size.x + 2.0F * inset_px, corner.y + size.y + inset_px),
                     palette::kSurface, 3.0F);
  draw.AddText(font, font->FontSize, ImVec2(corner.x + inset_px, corner.y + 0.5F * inset_px),
               palette::kText, words.c_str());
}

}  // namespace impetus::inline viewers
