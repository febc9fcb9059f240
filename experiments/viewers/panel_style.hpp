// How ImGui's own controls look in a panel: this room's colours, and sizes that fit small text.
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <string>

namespace impetus::inline viewers {

/// In force from its construction to its end.
class PanelStyle {
 public:
  explicit PanelStyle(ImFont* font);
  ~PanelStyle();
  PanelStyle(const PanelStyle&) = delete;
  PanelStyle& operator=(const PanelStyle&) = delete;
};

/// The tooltip of the control drawn last, shown while the mouse is on it.
void panel_tooltip(const std::string& text);

/// A line that sets a part of the panel off, with its name.
void panel_heading(const char* name);

}  // namespace impetus::inline viewers
