// SPDX-License-Identifier: MIT
#include "experiments/window/pages/widgets.hpp"

#include <cmath>

#include "experiments/drawing/palette.hpp"
#include "experiments/window/pages/text_lines.hpp"

namespace impetus::inline window {
namespace {

constexpr float kButtonMargin = 0.8F;  // left and right of the words, of the font's size

float offset_for(Align align, float width_px, float line_px) {
  switch (align) {
    case Align::kCentre:
      return std::floor((width_px - line_px) / 2.0F);
    case Align::kRight:
      return std::floor(width_px - line_px);
    case Align::kLeft:
      break;
  }
  return 0.0F;
}

/// The words and their key in one line.
void draw_label(const ButtonLook& look, ImVec2 from) {
  const ImVec2 label_px = ImGui::CalcTextSize(look.label.c_str());
  const ImVec2 hint_px = ImGui::CalcTextSize(look.hint.c_str());
  const ImVec2 at(std::floor(from.x + (look.size_px.x - label_px.x - hint_px.x) / 2.0F),
                  std::floor(from.y + (look.size_px.y - label_px.y) / 2.0F));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddText(at, look.chosen ? palette::kOnAccent : palette::kText, look.label.c_str());
  draw.AddText(ImVec2(at.x + label_px.x, at.y),
               look.chosen ? palette::kOnAccent : palette::kQuietText, look.hint.c_str());
}

/// Words that are longer than the button is wide, over several lines.
void draw_long_label(const ButtonLook& look, ImVec2 from) {
  const ImFont& font = *ImGui::GetFont();
  const std::string words = look.label + look.hint;
  const float margin_px = kButtonMargin * font.FontSize;
  const auto lines = lines_of(words, font, look.size_px.x - 2.0F * margin_px);
  const float height_px = static_cast<float>(lines.size()) * line_height(font);
  ImVec2 at(
      std::floor(from.x + margin_px),
      std::floor(from.y + (look.size_px.y - height_px + line_height(font) - font.FontSize) / 2.0F));
  for (const std::string_view line : lines) {
    ImGui::GetWindowDrawList()->AddText(at, look.chosen ? palette::kOnAccent : palette::kText,
                                        line.data(), line.data() + line.size());
    at.y += line_height(font);
  }
}

/// Whether the words go over several lines: they are too long for one, and there is room.
bool is_broken(const ButtonLook& look) {
  return button_size(look.label, look.hint).x > look.size_px.x &&
         button_size(look.label, look.hint, look.size_px.x).y <= look.size_px.y;
}

}  // namespace

float draw_text(const std::string& text, ImFont* font, ImU32 colour, float width_px, Align align) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float height = 0.0F;
  for (const std::string_view line : lines_of(text, *font, width_px)) {
    const float line_px = width_of(line, *font);
    const ImVec2 at(origin.x + offset_for(align, width_px, line_px), origin.y + height);
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, colour, line.data(),
                                        line.data() + line.size());
    height += line_height(*font);
  }
  ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + height));
  return height;
}

ImVec2 button_size(const std::string& label, const std::string& hint, float widest_px) {
  const ImFont& font = *ImGui::GetFont();
  const float margins_px = 2.0F * kButtonMargin * font.FontSize;
  const float text_px = ImGui::CalcTextSize(label.c_str()).x + ImGui::CalcTextSize(hint.c_str()).x;
  const ImVec2 one_line(std::ceil(text_px + margins_px), std::round(1.9F * font.FontSize));
  if (one_line.x <= widest_px) {
    return one_line;
  }
  const std::size_t lines = lines_of(label + hint, font, widest_px - margins_px).size();
  return {widest_px, one_line.y + static_cast<float>(lines - 1) * line_height(font)};
}

bool draw_button(int id, const ButtonLook& look) {
  ImGui::PushID(id);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 to(from.x + look.size_px.x, from.y + look.size_px.y);
  const bool clicked = ImGui::InvisibleButton("button", look.size_px);
  const bool pressed = look.chosen || ImGui::IsItemActive();
  const ImU32 surface = ImGui::IsItemHovered() ? palette::kSurfaceHovered : palette::kSurface;
  const float rounding = ImGui::GetStyle().FrameRounding;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(from, to, pressed ? palette::kAccent : surface, rounding);
  draw.AddRect(from, to, pressed ? palette::kAccent : palette::kLine, rounding);
  ButtonLook drawn = look;
  drawn.chosen = pressed;
  is_broken(look) ? draw_long_label(drawn, from) : draw_label(drawn, from);
  if (look.focused) {
    draw_focus_ring(from, to);
  }
  ImGui::PopID();
  return clicked;
}

void push_clip_rect(const PixelArea& area, float window_height_px) {
  const auto left = static_cast<float>(area.left);
  const float top = window_height_px - static_cast<float>(area.bottom + area.height);
  ImGui::PushClipRect(
      ImVec2(left, top),
      ImVec2(left + static_cast<float>(area.width), top + static_cast<float>(area.height)), true);
}

void draw_focus_ring(ImVec2 from, ImVec2 to) {
  constexpr float kGapPx = 2.0F;
  constexpr float kThicknessPx = 2.5F;
  ImGui::GetWindowDrawList()->AddRect(ImVec2(from.x - kGapPx, from.y - kGapPx),
                                      ImVec2(to.x + kGapPx, to.y + kGapPx), palette::kAccent,
                                      ImGui::GetStyle().FrameRounding + kGapPx, 0, kThicknessPx);
}

}  // namespace impetus::inline window
