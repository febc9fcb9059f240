// SPDX-License-Identifier: MIT
#include "experiments/window/pages/text_lines.hpp"

#include <cmath>

namespace impetus::inline window {
namespace {

constexpr float kLineHeight = 1.35F;  // of the font's size

const char* end_of_line(const char* begin, const char* end, const ImFont& font, float width_px) {
  const char* line_break = begin;
  while (line_break < end && *line_break != '\n') {
    ++line_break;
  }
  const char* wrapped = font.CalcWordWrapPositionA(1.0F, begin, line_break, width_px);
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

}  // namespace

float line_height(const ImFont& font) { return std::round(font.FontSize * kLineHeight); }

std::vector<std::string_view> lines_of(const std::string& text, const ImFont& font,
                                       float width_px) {
  std::vector<std::string_view> lines;
  const char* end = text.c_str() + text.size();
  for (const char* line = text.c_str(); line < end;) {
    const char* line_end = end_of_line(line, end, font, width_px);
    lines.emplace_back(line, line_end - line);
    line = start_of_next_line(line_end, end);
  }
  return lines;
}

float width_of(std::string_view text, const ImFont& font) {
  return font.CalcTextSizeA(font.FontSize, 1e6F, 0.0F, text.data(), text.data() + text.size()).x;
}

}  // namespace impetus::inline window
