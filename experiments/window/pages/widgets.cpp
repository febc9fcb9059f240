// SPDX-License-Identifier: MIT
#include "experiments/window/pages/widgets.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/record/shown_letters.hpp"
#include "experiments/window/right_to_left.hpp"

namespace impetus::inline window {
namespace {

constexpr float kLineHeight = 1.35F;  // of the font's size

/// Signs that never begin a line, and those that never end one.
constexpr std::u16string_view kClosing = u"，。、；：？！）》〉」』】”’…—·)]}.,;:?!%°";
constexpr std::u16string_view kOpening = u"（《〈「『【“‘([{";

/// A letter of a text in UTF-8, and how many bytes it takes.
struct Letter {
  unsigned code{0};
  int bytes{0};
};

Letter letter_at(const char* at, const char* end) {
  Letter letter;
  letter.bytes = std::max(1, ImTextCharFromUtf8(&letter.code, at, end));
  return letter;
}

bool has_wide_letter(const char* begin, const char* end) {
  for (const char* at = begin; at < end;) {
    const Letter letter = letter_at(at, end);
    if (is_wide_letter(letter.code)) {
      return true;
    }
    at += letter.bytes;
  }
  return false;
}

/// Whether a line may end between two letters: after a space, and beside an ideograph, but not so
/// that a line begins or ends with a sign that belongs to its neighbour.
bool may_break(unsigned before, unsigned after) {
  const bool is_beside_wide = is_wide_letter(before) || is_wide_letter(after);
  const auto is_one = [](unsigned code, std::u16string_view signs) {
    return code <= 0xFFFF && signs.find(static_cast<char16_t>(code)) != signs.npos;
  };
  return before == ' ' ||
         (is_beside_wide && after != ' ' && !is_one(after, kClosing) && !is_one(before, kOpening));
}

/// The same for a text in a script that sets no spaces between words.
const char* end_of_wide_line(const char* begin, const char* end, const ImFont& font,
                             float width_px) {
  const char* last_break = nullptr;
  float line_px = 0.0F;
  unsigned before = 0;
  for (const char* at = begin; at < end;) {
    const Letter letter = letter_at(at, end);
    if (at > begin && may_break(before, letter.code)) {
      last_break = at;
    }
    line_px += font.GetCharAdvance(static_cast<ImWchar>(letter.code));
    if (line_px > width_px && at > begin && letter.code != ' ') {
      while (last_break != nullptr && last_break > begin && last_break[-1] == ' ') {
        --last_break;
      }
      return last_break != nullptr ? last_break : at;
    }
    before = letter.code;
    at += letter.bytes;
  }
  return end;
}

/// The same for words of which some are read from right to left, whose letters join.
const char* end_of_joined_line(const char* begin, const char* end, const ImFont& font,
                               float width_px) {
  const char* fitting = begin;
  for (const char* at = begin; at < end;) {
    const char* word_end = std::find(at + 1, end, ' ');
    const std::string_view line(begin, static_cast<std::size_t>(word_end - begin));
    if (fitting > begin && width_of(visual_label(line), font) > width_px) {
      return fitting;
    }
    fitting = word_end;
    at = word_end;
  }
  return end;
}

const char* end_of_line(const char* begin, const char* end, const ImFont& font, float width_px) {
  const char* line_break = std::find(begin, end, '\n');
  if (has_right_to_left({begin, static_cast<std::size_t>(line_break - begin)})) {
    return end_of_joined_line(begin, line_break, font, width_px);
  }
  if (has_wide_letter(begin, line_break)) {
    return end_of_wide_line(begin, line_break, font, width_px);
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

constexpr float kButtonMargin = 0.8F;  // left and right of the words, of the font's size

float offset_for(Align align, float width_px, float line_px) {
  return align == Align::kCentre  ? std::floor((width_px - line_px) / 2.0F)
         : align == Align::kRight ? std::floor(width_px - line_px)
                                  : 0.0F;
}

/// The words and their key in one line: the key comes after the words, as they are read.
void draw_label(const ButtonLook& look, ImVec2 from) {
  const bool from_right = is_right_to_left(look.label);
  const std::string label = visual_line(look.label, from_right);
  const std::string hint = visual_line(look.hint, from_right);
  const ImVec2 label_px = ImGui::CalcTextSize(label.c_str());
  const ImVec2 hint_px = ImGui::CalcTextSize(hint.c_str());
  const ImVec2 at(std::floor(from.x + (look.size_px.x - label_px.x - hint_px.x) / 2.0F),
                  std::floor(from.y + (look.size_px.y - label_px.y) / 2.0F));
  write_at(ImVec2(at.x + (from_right ? hint_px.x : 0.0F), at.y), label, ImGui::GetFont(),
           look.chosen ? palette::kOnAccent : palette::kText);
  write_at(ImVec2(at.x + (from_right ? 0.0F : label_px.x), at.y), hint, ImGui::GetFont(),
           look.chosen ? palette::kOnAccent : palette::kQuietText);
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
  const bool from_right = is_right_to_left(words);
  for (const std::string_view line : lines) {
    const std::string shown = visual_line(line, from_right);
    const float free_px = look.size_px.x - 2.0F * margin_px - width_of(shown, font);
    write_at(ImVec2(at.x + (from_right ? std::floor(free_px) : 0.0F), at.y), shown,
             ImGui::GetFont(), look.chosen ? palette::kOnAccent : palette::kText);
    at.y += line_height(font);
  }
}

/// Whether the words go over several lines: they are too long for one, and there is room.
bool is_broken(const ButtonLook& look) {
  return button_size(look.label, look.hint).x > look.size_px.x &&
         button_size(look.label, look.hint, look.size_px.x).y <= look.size_px.y;
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

void write_at(ImVec2 corner, std::string_view text, ImFont* font, ImU32 colour) {
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, corner, colour, text.data(),
                                      text.data() + text.size());
}

float draw_text(const std::string& text, ImFont* font, ImU32 colour, float width_px, Align align) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const bool from_right = is_right_to_left(text);
  const Align side = align != Align::kStart ? align : from_right ? Align::kRight : Align::kLeft;
  float height = 0.0F;
  for (const std::string_view read : lines_of(text, *font, width_px)) {
    const std::string line = visual_line(read, from_right);
    const float line_px = width_of(line, *font);
    write_at(origin + ImVec2(offset_for(side, width_px, line_px), height), line, font, colour);
    height += line_height(*font);
  }
  ImGui::SetCursorScreenPos(origin + ImVec2(0.0F, height));
  return height;
}

ImVec2 button_size(const std::string& label, const std::string& hint, float widest_px) {
  const ImFont& font = *ImGui::GetFont();
  const float margins_px = 2.0F * kButtonMargin * font.FontSize;
  const float text_px =
      ImGui::CalcTextSize(visual_label(label).c_str()).x + ImGui::CalcTextSize(hint.c_str()).x;
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
  const ImVec2 to = from + look.size_px;
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
  const ImVec2 size(static_cast<float>(area.width), static_cast<float>(area.height));
  ImGui::PushClipRect(ImVec2(left, top), ImVec2(left, top) + size, true);
}

ImVec2 draw_card(const Gui& gui, ImVec2 size_px) {
  const ImVec2 from(std::round(0.5F * (gui.width() - size_px.x)),
                    std::round(0.5F * (gui.height() - size_px.y)));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(from, from + size_px, palette::kSurface, 6.0F);
  draw.AddRect(from, from + size_px, palette::kLine, 6.0F);
  return from;
}

void draw_focus_ring(ImVec2 from, ImVec2 to) {
  const ImVec2 gap(2.0F, 2.0F);
  constexpr float kThicknessPx = 2.5F;
  ImGui::GetWindowDrawList()->AddRect(from - gap, to + gap, palette::kAccent,
                                      ImGui::GetStyle().FrameRounding + gap.x, 0, kThicknessPx);
}

void ButtonRows::place(ImVec2 size_px) {
  if (at_.x > origin_.x && at_.x + size_px.x > origin_.x + width_px_) {
    at_ = ImVec2(origin_.x, at_.y + row_px_ + gap_px_);
    row_px_ = 0.0F;
  }
  const float from_left_px = at_.x - origin_.x;
  const float left_px = from_right_ ? width_px_ - from_left_px - size_px.x : from_left_px;
  ImGui::SetCursorScreenPos(ImVec2(origin_.x + left_px, at_.y));
  at_.x += size_px.x + gap_px_;
  row_px_ = std::max(row_px_, size_px.y);
}

}  // namespace impetus::inline window
