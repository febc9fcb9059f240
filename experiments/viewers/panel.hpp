// What the panels of viewers are made of: ImGui's own controls in this room's colours, with sizes
// that fit small text. A control returns whether it changed its value.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// A panel from `left_px` to the window's right edge: in force from its construction to its end.
class Panel {
 public:
  Panel(const Gui& gui, float left_px);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
};

/// The tooltip of the control drawn last, shown while the mouse is on it.
void panel_tooltip(const std::string& text);

/// A line that sets a part of the panel off, with its name.
void panel_heading(const char* name);

/// A part of the panel that folds away; true while it is open.
bool panel_section(const char* name, bool open_at_first);

/// A name in the left third; the control that follows takes the rest.
void panel_label(const char* name);

/// A cell of a table for the name, and one for the value.
void panel_row(const std::string& name, const std::string& value);

bool panel_box(const char* name, bool& value, const char* tooltip);

/// A number that is dragged or typed, as wide as there is room.
template <typename Number>
bool dragged_number(const char* id, Number& value, float speed, Number least, Number most,
                    const char* format, const std::string& tooltip) {
  constexpr auto kType = std::is_same_v<Number, int> ? ImGuiDataType_S32 : ImGuiDataType_Double;
  ImGui::SetNextItemWidth(-1.0F);
  const bool changed = ImGui::DragScalar(id, kType, &value, speed, &least, &most, format,
                                         ImGuiSliderFlags_AlwaysClamp);
  panel_tooltip(tooltip + " Drag to change, double-click to type.");
  return changed;
}

/// A list of which one name is shown; which was clicked.
std::optional<std::size_t> clicked_name(const char* id, const std::string& shown,
                                        const std::vector<std::string>& names);

/// A labelled list of which one name is chosen.
bool chosen_name(const char* label, std::string& chosen, const std::vector<std::string>& names,
                 const char* tooltip);

/// A value and what it is called.
template <typename Value>
struct NamedValue {
  Value value;
  const char* name;
};

/// A labelled list of which one value is chosen: of an array or vector of NamedValue.
template <typename Value, typename Choices>
bool chosen_value(const char* label, Value& value, const Choices& choices, const char* tooltip) {
  std::string chosen;
  std::vector<std::string> names;
  for (const NamedValue<Value>& choice : choices) {
    names.emplace_back(choice.name);
    chosen = choice.value == value ? choice.name : chosen;
  }
  const bool changed = chosen_name(label, chosen, names, tooltip);
  for (const NamedValue<Value>& choice : choices) {
    value = changed && choice.name == chosen ? choice.value : value;
  }
  return changed;
}

}  // namespace impetus::inline viewers
