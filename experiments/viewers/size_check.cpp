// SPDX-License-Identifier: MIT
#include "experiments/viewers/size_check.hpp"

#include <cmath>
#include <string>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

// ISO/IEC 7810 ID-1
constexpr double kCardWidthM = 0.08560;
constexpr double kCardHeightM = 0.05398;
constexpr double kCardCornerM = 0.00318;
constexpr int kRulerCm = 10;

void draw_label(const Gui& gui, ImVec2 at, const std::string& text) {
  ImFont* font = gui.fonts().small;
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, palette::kQuietText, text.c_str());
}

void draw_card(const Gui& gui, ImVec2 from, ImVec2 size_px, float corner_px) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 to(from.x + size_px.x, from.y + size_px.y);
  draw.AddRectFilled(from, to, palette::kSurface, corner_px);
  draw.AddRect(from, to, palette::kText, corner_px, 0, 1.5F);
  const float font_px = gui.fonts().small->FontSize;
  draw_label(gui, ImVec2(from.x + font_px, from.y + font_px), "bank card, 85.6 × 54.0 mm");
}

void draw_ruler(const Gui& gui, ImVec2 from, double pixels_per_cm) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float font_px = gui.fonts().small->FontSize;
  const auto x = [&](double cm) { return from.x + static_cast<float>(cm * pixels_per_cm); };
  draw.AddLine(from, ImVec2(x(kRulerCm), from.y), palette::kText, 1.5F);
  for (int half_cm = 0; half_cm <= 2 * kRulerCm; ++half_cm) {
    const bool whole = half_cm % 2 == 0;
    const float at = x(0.5 * half_cm);
    draw.AddLine(ImVec2(at, from.y), ImVec2(at, from.y + (whole ? 0.8F : 0.45F) * font_px),
                 palette::kText, 1.5F);
    if (whole) {
      const std::string number = std::to_string(half_cm / 2);
      const float width = gui.fonts().small->CalcTextSizeA(font_px, 1e6F, 0.0F, number.c_str()).x;
      draw_label(gui, ImVec2(at - width / 2.0F, from.y + font_px), number);
    }
  }
  draw_label(gui, ImVec2(x(kRulerCm) + font_px, from.y + font_px), "cm");
}

}  // namespace

void draw_card_and_ruler(const Gui& gui, ImVec2 from, ImVec2 to, const PixelsPerMetre& pixels) {
  const float bleed = 0.6F * gui.fonts().small->FontSize;  // for the ruler's first number
  const ImVec2 card_px(static_cast<float>(kCardWidthM * pixels.across),
                       static_cast<float>(kCardHeightM * pixels.down));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(ImVec2(from.x - bleed, from.y - bleed), to, true);
  draw_ruler(gui, from, pixels.across / 100.0);
  const ImVec2 card(from.x, from.y + 3.0F * gui.fonts().small->FontSize);
  draw_card(gui, card, card_px, static_cast<float>(kCardCornerM * pixels.across));
  draw.PopClipRect();
}

}  // namespace impetus::inline viewers
