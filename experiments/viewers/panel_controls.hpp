// The few kinds of control that a panel is made of; each returns whether it changed its value.
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <array>
#include <cstddef>
#include <string>

#include "experiments/viewers/panel_style.hpp"

namespace impetus::inline viewers {

/// A part of the panel that folds away; true while it is open.
bool panel_section(const char* name, bool open_at_first);

/// A name in the left third; the control that follows takes the rest.
void panel_label(const char* name);

/// A number that is dragged or typed, as wide as there is room.
bool dragged_number(const char* id, double& value, float speed, double least, double most,
                    const char* format, const std::string& tooltip);
bool dragged_number(const char* id, int& value, float speed, int least, int most,
                    const char* format, const std::string& tooltip);

void panel_box(const char* name, bool& value, const char* tooltip);

/// A value and what it is called, with a sentence about it.
template <typename Value>
struct NamedValue {
  Value value;
  const char* name;
};

/// A labelled list of which one value is chosen: of an array or vector of NamedValue.
template <typename Value, typename Choices>
bool chosen_of(const char* label, Value& value, const Choices& choices, const char* tooltip) {
  const char* current = "";
  for (const NamedValue<Value>& choice : choices) {
    current = choice.value == value ? choice.name : current;
  }
  bool changed = false;
  panel_label(label);
  ImGui::PushID(label);
  if (ImGui::BeginCombo("##choice", current)) {
    for (const NamedValue<Value>& choice : choices) {
      if (ImGui::Selectable(choice.name, choice.value == value)) {
        value = choice.value;
        changed = true;
      }
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  panel_tooltip(tooltip);
  return changed;
}

}  // namespace impetus::inline viewers
