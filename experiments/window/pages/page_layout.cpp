// SPDX-License-Identifier: MIT
#include "experiments/window/pages/page_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/right_to_left.hpp"
#include "experiments/window/typed_input.hpp"

namespace impetus::inline window {
namespace {

constexpr float kColumnEms = 36.0F;
constexpr float kWidestShare = 0.86F;
constexpr float kPointEms = 3.2F;  // of the points' own, larger text

std::string hint_for(const Page& page, const Choice& choice) {
  return choice.key.empty() || choice.label == choice.key
             ? ""
             : "  (" + printed_key(choice.key, page.progress.language) + ")";
}

ButtonLook look_of(const Page& page, std::size_t choice, ImVec2 size_px, const ChoiceMarks& marks) {
  return {page.choices[choice].label, hint_for(page, page.choices[choice]), size_px,
          marks.focused == choice, marks.chosen == choice};
}

void move_down(float pixels) {
  ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(0.0F, std::round(pixels)));
}

/// The size that the widest and the highest of the choices ask for, in the present font.
ImVec2 largest_button(const Page& page, float widest_px = std::numeric_limits<float>::max()) {
  ImVec2 largest(0.0F, 0.0F);
  for (const Choice& choice : page.choices) {
    largest = ImMax(largest, button_size(choice.label, hint_for(page, choice), widest_px));
  }
  return largest;
}

std::optional<std::size_t> draw_rows(const Page& page, const Column& column,
                                     const ChoiceMarks& marks) {
  std::optional<std::size_t> clicked;
  ImGui::SetCursorScreenPos(ImVec2(column.left, ImGui::GetCursorScreenPos().y));
  const bool from_right = !page.choices.empty() && is_right_to_left(page.choices.front().label);
  ButtonRows rows(column.width, std::round(0.7F * ImGui::GetFontSize()), from_right);
  for (std::size_t choice = 0; choice < page.choices.size(); ++choice) {
    const ImVec2 size_px =
        button_size(page.choices[choice].label, hint_for(page, page.choices[choice]), column.width);
    rows.place(size_px);
    if (draw_button(static_cast<int>(choice), look_of(page, choice, size_px, marks))) {
      clicked = choice;
    }
  }
  rows.end();
  return clicked;
}

/// Side by side, the first at the column's left edge and the last at its right.
std::optional<std::size_t> draw_points(const Page& page, const Column& column,
                                       const ChoiceMarks& marks) {
  std::optional<std::size_t> clicked;
  const auto count = static_cast<float>(page.choices.size());
  const float wanted_px = std::max(kPointEms * ImGui::GetFontSize(), largest_button(page).x);
  const float width_px = std::round(std::min(wanted_px, 0.86F * column.width / count));
  const ImVec2 size_px(width_px, std::round(2.1F * ImGui::GetFontSize()));
  const float apart_px = count > 1.0F ? (column.width - width_px) / (count - 1.0F) : 0.0F;
  const float top = ImGui::GetCursorScreenPos().y;
  for (std::size_t choice = 0; choice < page.choices.size(); ++choice) {
    const float left = column.left + std::round(static_cast<float>(choice) * apart_px);
    ImGui::SetCursorScreenPos(ImVec2(left, top));
    if (draw_button(static_cast<int>(choice), look_of(page, choice, size_px, marks))) {
      clicked = choice;
    }
  }
  ImGui::SetCursorScreenPos(ImVec2(column.left, top + size_px.y));
  return clicked;
}

constexpr float kClosestEms = 0.25F;  ///< between choices one below the other

/// The largest letters in which every label fits the width, and a line of it the height; none when
/// not even the smallest do.
ImFont* font_within(const Gui& gui, const Page& page, float width_px, float height_px) {
  const Fonts& fonts = gui.fonts();
  for (ImFont* font : {fonts.title[0], fonts.body[0], fonts.body[1]}) {
    ImGui::PushFont(font);
    const ImVec2 largest = largest_button(page);
    const bool fits =
        largest.x <= width_px && largest.y + kClosestEms * ImGui::GetFontSize() <= height_px;
    ImGui::PopFont();
    if (fits) {
      return font;
    }
  }
  return nullptr;
}

/// Side by side and of one size; one below the other when their words are long.
std::optional<std::size_t> draw_large_choices(const Gui& gui, const Page& page,
                                              const Column& column, const ChoiceMarks& marks,
                                              float bottom_px) {
  float gap_px = std::round(1.2F * ImGui::GetFontSize());
  const auto count = static_cast<float>(page.choices.size());
  const float share_px = std::floor((column.width - (count - 1.0F) * gap_px) / count);
  ImVec2 at(column.left, ImGui::GetCursorScreenPos().y);
  const float room_px = bottom_px - at.y;
  ImFont* font = font_within(gui, page, share_px, room_px);
  const bool abreast = font != nullptr;
  if (!abreast) {
    font = font_within(gui, page, column.width, room_px / count);
  }
  ImGui::PushFont(font != nullptr ? font : gui.fonts().body[kReadingSizes - 1]);
  const float width_px = abreast ? share_px : column.width;
  ImVec2 size_px(width_px, std::max(std::round(3.0F * ImGui::GetFontSize()),
                                    largest_button(page, width_px).y));
  std::optional<std::size_t> clicked;
  if (!abreast && count * (size_px.y + gap_px) > room_px) {  // closer, until all fit
    gap_px = std::round(kClosestEms * ImGui::GetFontSize());
    size_px.y = std::clamp(std::floor(room_px / count) - gap_px, largest_button(page, width_px).y,
                           size_px.y);
  }
  for (std::size_t choice = 0; choice < page.choices.size(); ++choice) {
    ImGui::SetCursorScreenPos(at);
    if (draw_button(static_cast<int>(choice), look_of(page, choice, size_px, marks))) {
      clicked = choice;
    }
    at.x += abreast ? size_px.x + gap_px : 0.0F;
    at.y += abreast ? 0.0F : size_px.y + gap_px;
  }
  ImGui::PopFont();
  ImGui::SetCursorScreenPos(ImVec2(column.left, abreast ? at.y + size_px.y : at.y - gap_px));
  return clicked;
}

/// Beside a bar, as a quotation is set.
void draw_statement(const std::string& statement, ImFont* font, const Column& column) {
  const float indent_px = std::round(0.8F * font->FontSize);
  const float bar_px = std::round(0.18F * font->FontSize);
  const bool from_right = is_right_to_left(statement);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(column.left + (from_right ? 0.0F : indent_px), from.y));
  const float height_px =
      draw_text(statement, font, palette::kText, column.width - indent_px, Align::kStart);
  const float bottom = from.y + height_px - (line_height(*font) - font->FontSize);
  const float bar_left = column.left + (from_right ? column.width - bar_px : 0.0F);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(bar_left, from.y),
                                            ImVec2(bar_left + bar_px, bottom), palette::kAccent);
  ImGui::SetCursorScreenPos(ImVec2(from.x, from.y + height_px));
}

void draw_anchors(const Gui& gui, const Page& page, const Column& column) {
  ImFont* font = gui.fonts().body[1];
  const float width_px = 0.42F * column.width;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float low = draw_text(page.low_anchor, font, palette::kText, width_px, Align::kLeft);
  ImGui::SetCursorScreenPos(ImVec2(column.left + column.width - width_px, at.y));
  const float high = draw_text(page.high_anchor, font, palette::kText, width_px, Align::kRight);
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + std::max(low, high)));
}

constexpr float kBarShareOfHeight = 0.006F;

/// The bar's inks.
struct Colours {
  ImU32 track;
  ImU32 done;
  ImU32 label;
};

Colours colours_on(BarPlace place, bool light_ground) {
  if (place == BarPlace::kPicture) {
    return {IM_COL32(118, 118, 118, 255), IM_COL32(92, 92, 92, 255), IM_COL32(82, 82, 82, 255)};
  }
  return light_ground ? Colours{IM_COL32(186, 186, 186, 255), IM_COL32(128, 128, 130, 255),
                                palette::kQuietText}
                      : Colours{IM_COL32(114, 114, 114, 255), IM_COL32(74, 74, 76, 255),
                                palette::kQuietText};
}

/// Quiet, for the experimenter: a ring, and what it means in two words.
void draw_lost_gaze_mark(ImDrawList& draw, ImVec2 at, const ImFont& font, ImU32 colour,
                         const std::string& words) {
  const float radius = 0.3F * font.FontSize;
  draw.AddCircle(ImVec2(at.x + radius, at.y + 0.55F * font.FontSize), radius, colour, 0, 1.5F);
  draw.AddText(&font, font.FontSize, at + ImVec2(3.0F * radius, 0.0F), colour,
               visual_label(words).c_str());
}

float bar_height(const Gui& gui) {
  return std::max(4.0F, std::round(gui.height() * kBarShareOfHeight));
}

}  // namespace

Column reading_column(const Gui& gui) {
  const float em_px = gui.fonts().body[0]->FontSize;
  const float width = std::round(std::min(kColumnEms * em_px, kWidestShare * gui.width()));
  return {std::floor((gui.width() - width) / 2.0F), width};
}

float part_gap() { return std::round(0.9F * ImGui::GetFontSize()); }

void draw_words(const Gui& gui, const Page& page, std::size_t reading_size) {
  const Column column = reading_column(gui);
  const bool is_centred =
      page.layout == Page::Layout::kScale || page.layout == Page::Layout::kChoices;
  const Align align = is_centred ? Align::kCentre : Align::kStart;
  if (!page.title.empty()) {
    draw_text(page.title, gui.fonts().title[reading_size], palette::kText, column.width, align);
    move_down(part_gap());
  }
  for (const std::string& paragraph : page.paragraphs) {
    draw_text(paragraph, gui.fonts().body[reading_size], palette::kText, column.width, align);
    move_down(0.65F * ImGui::GetFontSize());
  }
  if (!page.statement.empty()) {
    draw_statement(page.statement, gui.fonts().body[reading_size], column);
  }
}

std::optional<std::size_t> draw_choices(const Gui& gui, const Page& page, const ChoiceMarks& marks,
                                        float bottom_px) {
  const Column column = reading_column(gui);
  move_down(part_gap());
  if (page.layout == Page::Layout::kChoices) {
    move_down(part_gap());
    return draw_large_choices(gui, page, column, marks, bottom_px);
  }
  if (page.layout != Page::Layout::kScale) {
    return draw_rows(page, column, marks);
  }
  move_down(part_gap());
  ImGui::PushFont(gui.fonts().title[0]);
  const auto clicked = draw_points(page, column, marks);
  ImGui::PopFont();
  move_down(0.5F * ImGui::GetFontSize());
  draw_anchors(gui, page, column);
  if (page.choices.size() > 1) {
    move_down(1.5F * part_gap());
    const Language& language = page.progress.language;
    draw_text(
        language.text("press_or_click", {{"first", printed_key(page.choices.front().key, language)},
                                         {"last", printed_key(page.choices.back().key, language)}}),
        gui.fonts().small, palette::kQuietText, column.width, Align::kCentre);
  }
  return clicked;
}

void draw_point_map(const Gui& gui, const PointMap& map, const Language& language) {
  if (map.points.empty()) {
    return;
  }
  constexpr float kHeightShare = 0.26F;  // of the window's
  constexpr float kPointRadius = 0.28F;  // of a letter's height
  constexpr ImU32 kScreenColour = IM_COL32(128, 128, 128, 255);
  const Column column = reading_column(gui);
  const float height = std::round(kHeightShare * gui.height());
  const float width = std::round(height * static_cast<float>(map.aspect));
  const ImVec2 corner(column.left, ImGui::GetCursorScreenPos().y + std::round(0.4F * part_gap()));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 far_corner = corner + ImVec2(width, height);
  draw.AddRectFilled(corner, far_corner, kScreenColour);
  const auto place = [&](double x, double y) {
    return ImVec2(corner.x + width * static_cast<float>(0.5 + x),
                  corner.y + height * static_cast<float>(0.5 - y));
  };
  const float radius = kPointRadius * ImGui::GetFontSize();
  draw.PushClipRect(corner, far_corner, true);
  for (const LookedAtPoint& point : map.points) {
    const ImVec2 shown = place(point.x, point.y);
    draw.AddCircle(shown, radius, palette::kText, 0, 1.5F);
    if (point.seen) {
      const ImVec2 gaze = place(point.gaze_x, point.gaze_y);
      draw.AddLine(shown, gaze, palette::kOnAccent, 1.5F);
      draw.AddCircleFilled(gaze, 0.6F * radius, palette::kOnAccent);
    }
  }
  draw.PopClipRect();
  ImGui::SetCursorScreenPos(ImVec2(column.left, corner.y + height + std::round(0.3F * part_gap())));
  draw_text(language.text("map_caption"), gui.fonts().small, palette::kQuietText, column.width,
            Align::kStart);
}

float progress_height(const Gui& gui) {
  return bar_height(gui) + std::round(1.7F * gui.fonts().small->FontSize);
}

void draw_progress(const Gui& gui, const SessionProgress& progress, BarPlace place) {
  if (progress.total <= 0 && progress.label.empty()) {
    return;
  }
  const Colours colours = colours_on(place, progress.light_ground);
  const double share =
      progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total)
                         : 0.0;
  const float top = gui.height() - bar_height(gui);
  const float done_px = gui.width() * static_cast<float>(std::clamp(share, 0.0, 1.0));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(ImVec2(0, top), ImVec2(gui.width(), gui.height()), colours.track);
  draw.AddRectFilled(ImVec2(0, top), ImVec2(done_px, gui.height()), colours.done);

  ImFont* font = gui.fonts().small;
  const std::string label = visual_label(progress.label);
  const ImVec2 label_px = font->CalcTextSizeA(font->FontSize, 1e6F, 0.0F, label.c_str());
  const ImVec2 at(std::floor((gui.width() - label_px.x) / 2.0F),
                  std::floor(top - 1.35F * font->FontSize));
  draw.AddText(font, font->FontSize, at, colours.label, label.c_str());
  if (progress.gaze_was_lost) {
    draw_lost_gaze_mark(draw, ImVec2(at.x + label_px.x + font->FontSize, at.y), *font,
                        colours.label, progress.language.text("gaze_lost_mark"));
  }
}

}  // namespace impetus::inline window
