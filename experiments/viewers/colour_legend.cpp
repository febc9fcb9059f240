// SPDX-License-Identifier: MIT
#include "experiments/viewers/colour_legend.hpp"

#include <imgui.h>

#include <algorithm>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

ImU32 opaque(const BodyColour& colour) {
  return ImGui::ColorConvertFloat4ToU32(ImVec4(colour[0], colour[1], colour[2], 1.0F));
}

float text_width(ImFont* font, const std::string& text) {
  return font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, text.c_str()).x;
}

}  // namespace

void draw_colour_legend(const Gui& gui, const PixelArea& area,
                        const std::vector<ColourMeaning>& meanings, const std::string& note) {
  const std::size_t lines = meanings.size() + (note.empty() ? 0 : 1);
  if (lines == 0) {
    return;
  }
  ImFont* font = gui.fonts().small;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line_px = 1.35F * font->FontSize;
  const float inset_px = 0.5F * font->FontSize;
  const float indent_px = meanings.empty() ? 0.0F : 1.5F * font->FontSize;
  float width_px = text_width(font, note);
  for (const ColourMeaning& each : meanings) {
    width_px = std::max(width_px, indent_px + text_width(font, each.meaning));
  }
  const ImVec2 corner(static_cast<float>(area.left) + inset_px,
                      gui.height() - static_cast<float>(area.bottom) - inset_px);
  const float top_px = corner.y - static_cast<float>(lines) * line_px - 2.0F * inset_px;
  draw.AddRectFilled(ImVec2(corner.x, top_px),
                     ImVec2(corner.x + width_px + 2.0F * inset_px, corner.y), palette::kSurface,
                     3.0F);
  float y = top_px + inset_px;
  const float x = corner.x + inset_px;
  for (const ColourMeaning& each : meanings) {
    draw.AddRectFilled(ImVec2(x, y), ImVec2(x + font->FontSize, y + font->FontSize),
                       opaque(each.colour), 2.0F);
    draw.AddText(font, font->FontSize, ImVec2(x + indent_px, y), palette::kText,
                 each.meaning.c_str());
    y += line_px;
  }
  draw.AddText(font, font->FontSize, ImVec2(x, y), palette::kText, note.c_str());
}

void draw_colour_line(const Gui& gui, const PixelArea& area,
                      const std::vector<ColourMeaning>& meanings) {
  if (meanings.empty()) {
    return;
  }
  ImFont* font = gui.fonts().small;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line_px = 1.35F * font->FontSize;
  const float inset_px = 0.5F * font->FontSize;
  const float left = static_cast<float>(area.left) + 2.0F * inset_px;
  const float most_px = static_cast<float>(area.width) - 4.0F * inset_px;
  std::vector<ImVec2> places;
  ImVec2 at(0.0F, 0.0F);
  float widest_px = 0.0F;
  for (const ColourMeaning& each : meanings) {
    const float width_px = 1.3F * font->FontSize + text_width(font, each.meaning);
    if (at.x > 0.0F && at.x + width_px > most_px) {
      at = ImVec2(0.0F, at.y + line_px);
    }
    places.push_back(at);
    widest_px = std::max(widest_px, at.x + width_px);
    at.x += width_px + font->FontSize;
  }
  const float bottom = gui.height() - static_cast<float>(area.bottom) - inset_px;
  const float top = bottom - at.y - line_px - 0.5F * inset_px;
  draw.AddRectFilled(ImVec2(left - inset_px, top), ImVec2(left + widest_px + inset_px, bottom),
                     palette::kSurface, 3.0F);
  for (std::size_t i = 0; i < meanings.size(); ++i) {
    const ImVec2 from(left + places[i].x, top + 0.5F * inset_px + places[i].y);
    draw.AddRectFilled(from, ImVec2(from.x + font->FontSize, from.y + font->FontSize),
                       opaque(meanings[i].colour), 2.0F);
    draw.AddText(font, font->FontSize, ImVec2(from.x + 1.3F * font->FontSize, from.y),
                 palette::kText, meanings[i].meaning.c_str());
  }
}

}  // namespace impetus::inline viewers
