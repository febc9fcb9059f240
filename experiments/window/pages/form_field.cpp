// SPDX-License-Identifier: MIT
#include "experiments/window/pages/form_field.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

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

// ImGui does not wrap what is edited. Enter leaves a form, so every line break in the text is ours:
// turning a space into a break and back keeps the length, and the cursor where it is.
int wrap_lines(ImGuiInputTextCallbackData* data) {
  const float width_px = *static_cast<const float*>(data->UserData);
  std::replace(data->Buf, data->Buf + data->BufTextLen, '\n', ' ');
  const char* line = data->Buf;
  char* last_space = nullptr;
  for (char* at = data->Buf; at < data->Buf + data->BufTextLen; ++at) {
    const bool too_long = ImGui::CalcTextSize(line, at + 1).x > width_px;
    if (*at != ' ' && too_long && last_space != nullptr) {
      *last_space = '\n';
      line = last_space + 1;
      last_space = nullptr;
    }
    last_space = *at == ' ' ? at : last_space;
  }
  data->BufDirty = true;
  return 0;
}

std::string shown_number(double value, const Language& language) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
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

FocusChange FormField::draw(int id, const Gui& gui, std::size_t reading_size, float width_px,
                            bool focused, bool take_keyboard) {
  ImGui::PushID(id);
  draw_text(field_.label, gui.fonts().body[reading_size], palette::kText, width_px, Align::kStart);
  const FocusChange change =
      takes_text() ? draw_entry(width_px, focused, take_keyboard) : draw_options(width_px, focused);
  if (focused && takes_text()) {
    draw_focus_ring(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  }
  if (!message_.empty()) {
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
    const ImGuiStyle& style = ImGui::GetStyle();
    float inside_px = width_px - 2.0F * style.FramePadding.x - style.ScrollbarSize - 2.0F;
    const float height_px = kTextBoxLines * ImGui::GetFontSize() + 2.0F * style.FramePadding.y;
    ImGui::InputTextMultiline("##text", &text_, ImVec2(width_px, height_px),
                              ImGuiInputTextFlags_CallbackEdit, wrap_lines, &inside_px);
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

bool FormField::press(SDL_Keycode key) {
  if (field_.kind != Field::Kind::kChoice || field_.options.empty()) {
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
  if (field_.kind != Field::Kind::kNumber || text_.empty()) {
    return true;
  }
  const auto number = typed_number(text_);
  const bool bounded = field_.minimum < field_.maximum;
  const bool inside =
      number && (!bounded || (*number >= field_.minimum && *number <= field_.maximum));
  if (!inside && bounded) {
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
  return trimmed(text_);
}

}  // namespace impetus::inline window
