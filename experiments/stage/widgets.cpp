// SPDX-License-Identifier: MIT
#include "experiments/stage/widgets.hpp"

#include <cmath>

#include "experiments/stage/palette.hpp"

namespace impetus {
namespace {

constexpr float kLineHeight = 1.35F;  // of the font's size

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

const char* end_of_line(const char* begin, const char* end, const ImFont* font, float width_px) {
  const char* line_break = begin;
  while (line_break < end && *line_break != '\n') {
    ++line_break;
  }
  const char* wrapped = font->CalcWordWrapPositionA(1.0F, begin, line_break, width_px);
  return wrapped > begin ? wrapped : line_break;
}

const char* start_of_next_line(const char* at, const char* end) {
  if (at < end && *at == '\n') {
    return at + 1;
  }
  while (at < end && *at == ' ') {
    ++at;
  }
  return at < end && *at == '\n' ? at + 1 : at;
}

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

}  // namespace

float draw_text(const std::string& text, ImFont* font, ImU32 colour, float width_px, Align align) {
  const float line_height = std::round(font->FontSize * kLineHeight);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const char* end = text.c_str() + text.size();
  float height = 0.0F;
  for (const char* line = text.c_str(); line < end;) {
    const char* line_end = end_of_line(line, end, font, width_px);
    const float line_px = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, line, line_end).x;
    const ImVec2 at(origin.x + offset_for(align, width_px, line_px), origin.y + height);
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, colour, line, line_end);
    height += line_height;
    line = start_of_next_line(line_end, end);
  }
  ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + height));
  return height;
}

ImVec2 button_size(const std::string& label, const std::string& hint) {
  const float font_px = ImGui::GetFontSize();
  const float text_px = ImGui::CalcTextSize(label.c_str()).x + ImGui::CalcTextSize(hint.c_str()).x;
  return {std::ceil(text_px + 1.6F * font_px), std::round(1.9F * font_px)};
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
  draw_label(drawn, from);
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

}  // namespace impetus
