// SPDX-License-Identifier: MIT
#include "experiments/window/pages/form_field.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "experiments/tables/number_text.hpp"
#include "experiments/window/pages/text_box.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/right_to_left.hpp"
#include "experiments/window/typed_input.hpp"

namespace impetus::inline window {
namespace {

constexpr float kNumberWidth = 7.0F;  // of the font's size
constexpr float kTextBoxLines = 4.0F;

int keep_number_characters(ImGuiInputTextCallbackData* data) {
  if (data->EventChar == ',') {
    data->EventChar = '.';
  }
  const bool digit = data->EventChar >= '0' && data->EventChar <= '9';
  return digit || data->EventChar == '.' || data->EventChar == '-' ? 0 : 1;
}

std::string shown_number(double value, const Language& language) {
  const std::string text = printed("%g", value);
  return language.number(text);
}

std::string trimmed(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) {
    return "";
  }
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

}  // namespace

FormField::FormField(Field field, Language language)
    : field_(std::move(field)), language_(std::move(language)) {
  const auto chosen = std::find(field_.options.begin(), field_.options.end(), field_.answer);
  if (takes_text()) {
    text_ = field_.answer;
  } else if (field_.kind == Field::Kind::kSlider) {
    mark_ = typed_number(field_.answer);
  } else if (chosen != field_.options.end()) {
    option_ = static_cast<std::size_t>(chosen - field_.options.begin());
  }
}

FocusChange FormField::draw(int id, const Gui& gui, std::size_t reading_size, float width_px,
                            bool focused, bool take_keyboard) {
  ImGui::PushID(id);
  ImFont* font = gui.fonts().body[reading_size];
  if (!field_.label.empty()) {
    draw_text(field_.label, font, palette::kText, width_px, Align::kStart);
  }
  const FocusChange change = takes_text() ? draw_entry(width_px, focused, take_keyboard)
                             : field_.kind == Field::Kind::kSlider
                                 ? draw_slider(font, width_px, focused)
                                 : draw_options(width_px, focused);
  if (focused && takes_text()) {
    draw_focus_ring(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  if (!message_.empty() && field_.kind != Field::Kind::kSlider) {
    draw_message(gui.fonts().small);
  }
  ImGui::PopID();
  return change;
}

/// Beside the entry, so that nothing else moves.
void FormField::draw_message(ImFont* font) const {
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  const std::string message = visual_label(message_);
  const float gap_px = 0.6F * ImGui::GetFontSize();
  const float left =
      is_right_to_left(field_.label) ? from.x - gap_px - width_of(message, *font) : to.x + gap_px;
  write_at(ImVec2(std::round(left), std::round((from.y + to.y - font->FontSize) / 2.0F)), message,
           font, palette::kWarning);
}

FocusChange FormField::draw_entry(float width_px, bool focused, bool take_keyboard) {
  if (take_keyboard) {
    ImGui::SetKeyboardFocusHere();
  }
  if (field_.kind == Field::Kind::kNumber) {
    const float number_px = std::min(width_px, kNumberWidth * ImGui::GetFontSize());
    if (is_right_to_left(field_.label)) {
      ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() + ImVec2(width_px - number_px, 0.0F));
    }
    ImGui::SetNextItemWidth(number_px);
    ImGui::InputText("##number", &text_, ImGuiInputTextFlags_CallbackCharFilter,
                     keep_number_characters);
  } else {
    const float padding_px = 2.0F * ImGui::GetStyle().FramePadding.y;
    draw_text_box(text_, ImVec2(width_px, kTextBoxLines * ImGui::GetFontSize() + padding_px),
                  is_right_to_left(field_.label, is_right_to_left(language_.text("continue"))));
  }
  const bool active = ImGui::IsItemActive();
  const bool left = was_active_ && !active && focused && !take_keyboard;
  was_active_ = active;
  return active && !focused ? FocusChange::kGained : left ? FocusChange::kLost : FocusChange::kNone;
}

FocusChange FormField::draw_options(float width_px, bool focused) {
  FocusChange change = FocusChange::kNone;
  ButtonRows rows(width_px, 0.4F * ImGui::GetFontSize(), is_right_to_left(field_.label));
  for (std::size_t option = 0; option < field_.options.size(); ++option) {
    const ImVec2 size_px = button_size(field_.options[option], "", width_px);
    rows.place(size_px);
    const bool chosen = option_ == option;
    const bool ringed = focused && option == option_.value_or(0);
    const int id = static_cast<int>(option);
    if (draw_button(id, {field_.options[option], "", size_px, ringed, chosen})) {
      option_ = chosen ? std::nullopt : std::optional(option);
      change = FocusChange::kGained;
    }
  }
  rows.end();
  ImGui::SetCursorScreenPos(ImGui::GetCursorScreenPos() +
                            ImVec2(0.0F, ImGui::GetStyle().ItemSpacing.y));
  return change;
}

/// A line with a handle where the mark is, and the words under it.
FocusChange FormField::draw_slider(ImFont* font, float width_px, bool focused) {
  const float em_px = ImGui::GetFontSize();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size_px(width_px, std::round(2.4F * em_px));
  ImGui::InvisibleButton("##line", size_px);
  const bool is_held = ImGui::IsItemActive();
  const double span = field_.maximum - field_.minimum;
  if (is_held) {
    const double share = (ImGui::GetIO().MousePos.x - from.x) / width_px;
    mark_ = std::round(field_.minimum + span * std::clamp(share, 0.0, 1.0));
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float middle = std::round(from.y + 0.5F * size_px.y);
  const float thickness = std::max(2.0F, std::round(0.14F * em_px));
  draw.AddRectFilled(ImVec2(from.x, middle - thickness),
                     ImVec2(from.x + width_px, middle + thickness), palette::kSurface, thickness);
  draw.AddRect(ImVec2(from.x, middle - thickness), ImVec2(from.x + width_px, middle + thickness),
               palette::kLine, thickness);
  if (mark_) {
    const auto share = static_cast<float>((*mark_ - field_.minimum) / span);
    draw.AddCircleFilled(ImVec2(from.x + share * width_px, middle), 0.55F * em_px, palette::kAccent,
                         32);
  }
  if (focused) {
    draw_focus_ring(from, from + size_px);
  }
  const std::size_t last = field_.options.size() - 1;
  const float step_px = width_px / static_cast<float>(last);
  const float inner_px = width_px / static_cast<float>(last + 1);
  const float end_px = last == 1 ? inner_px : step_px - 0.5F * inner_px;
  float lowest = from.y + size_px.y;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool is_inner = i > 0 && i < last;
    const float part_px = is_inner ? inner_px : end_px;
    const float before = i == 0 ? 0.0F : is_inner ? 0.5F : 1.0F;  // the line's place, in parts
    const float left = std::round(static_cast<float>(i) * step_px - before * part_px);
    ImGui::SetCursorScreenPos(ImVec2(from.x + left, from.y + size_px.y + 0.3F * em_px));
    draw_text(field_.options[i], font, palette::kText, part_px,
              is_inner ? Align::kCentre
              : i == 0 ? Align::kLeft
                       : Align::kRight);
    lowest = std::max(lowest, ImGui::GetCursorScreenPos().y);
  }
  ImGui::SetCursorScreenPos(ImVec2(from.x, lowest));
  if (!message_.empty() && !mark_) {
    draw_text(message_, font, palette::kWarning, width_px, Align::kCentre);
  }
  return is_held && !focused ? FocusChange::kGained : FocusChange::kNone;
}

bool FormField::press(SDL_Keycode key) {
  return field_.kind == Field::Kind::kChoice   ? press_option(key)
         : field_.kind == Field::Kind::kSlider ? press_mark(key)
                                               : false;
}

/// The first key puts the mark in the middle.
bool FormField::press_mark(SDL_Keycode key) {
  const double span = field_.maximum - field_.minimum;
  const double by = key == SDLK_RIGHT  ? 1.0
                    : key == SDLK_LEFT ? -1.0
                    : key == SDLK_UP   ? std::round(0.1 * span)
                    : key == SDLK_DOWN ? -std::round(0.1 * span)
                                       : 0.0;
  if (by != 0.0) {
    const double middle = std::round(field_.minimum + 0.5 * span);
    mark_ = mark_ ? std::clamp(*mark_ + by, field_.minimum, field_.maximum) : middle;
  }
  return by != 0.0;
}

bool FormField::press_option(SDL_Keycode key) {
  if (field_.options.empty()) {
    return false;
  }
  const std::size_t last = field_.options.size() - 1;
  switch (key) {
    case SDLK_RIGHT:
      option_ = option_ ? std::min(*option_ + 1, last) : 0;
      return true;
    case SDLK_LEFT:
      option_ = option_.value_or(0) == 0 ? 0 : *option_ - 1;
      return true;
    case SDLK_SPACE:
      option_ = option_ ? std::nullopt : std::optional<std::size_t>(0);
      return true;
    default:
      return false;
  }
}

bool FormField::check() {
  message_.clear();
  if (field_.kind == Field::Kind::kSlider && !mark_) {
    message_ = language_.text("mark_needed");
    return false;
  }
  if (field_.kind != Field::Kind::kNumber || text_.empty()) {
    return true;
  }
  const auto number = typed_number(text_);
  const bool inside =
      number && (!field_.has_range() || (*number >= field_.minimum && *number <= field_.maximum));
  if (!inside && field_.has_range()) {
    message_ = language_.text("number_within", {{"least", shown_number(field_.minimum, language_)},
                                                {"most", shown_number(field_.maximum, language_)}});
  } else if (!inside) {
    message_ = language_.text("number_needed");
  }
  return inside;
}

std::string FormField::answer() const {
  if (field_.kind == Field::Kind::kChoice) {
    return option_ ? field_.options[*option_] : "";
  }
  if (field_.kind == Field::Kind::kSlider) {
    return mark_ ? std::to_string(std::llround(*mark_)) : "";
  }
  return trimmed(text_);
}

}  // namespace impetus::inline window
