// SPDX-License-Identifier: MIT
#include "experiments/viewers/panel.hpp"

#include <array>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

/// The colour of a part of ImGui's controls.
struct ColourOf {
  ImGuiCol what;
  ImU32 colour;
};

constexpr ImU32 kPressed = IM_COL32(190, 202, 214, 255);
constexpr ImU32 kGrab = IM_COL32(148, 170, 192, 255);  ///< a number can be read on it

constexpr std::array<ColourOf, 18> kStyleColours{
    {{ImGuiCol_ChildBg, palette::kLight},
     {ImGuiCol_PopupBg, palette::kSurfaceHovered},
     {ImGuiCol_Button, palette::kSurface},
     {ImGuiCol_ButtonHovered, palette::kSurfaceHovered},
     {ImGuiCol_ButtonActive, kPressed},
     {ImGuiCol_CheckMark, palette::kAccent},
     {ImGuiCol_SliderGrab, kGrab},
     {ImGuiCol_SliderGrabActive, kGrab},
     {ImGuiCol_Header, kPressed},
     {ImGuiCol_HeaderHovered, kPressed},
     {ImGuiCol_HeaderActive, kPressed},
     {ImGuiCol_Separator, palette::kLine},
     {ImGuiCol_TextDisabled, palette::kQuietText},
     {ImGuiCol_TableBorderLight, palette::kLine},
     {ImGuiCol_TableBorderStrong, palette::kLine},
     {ImGuiCol_ScrollbarBg, palette::kLight},
     {ImGuiCol_ScrollbarGrabHovered, palette::kQuietText},
     {ImGuiCol_ScrollbarGrabActive, palette::kAccent}}};

constexpr int kSizes = 6;

}  // namespace

Panel::Panel(const Gui& gui, float left_px) {
  const float em = gui.fonts().small->FontSize;
  ImGui::PushFont(gui.fonts().small);
  for (const ColourOf& each : kStyleColours) {
    ImGui::PushStyleColor(each.what, each.colour);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.35F * em, 0.2F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.45F * em, 0.34F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(0.4F * em, 0.3F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 0.2F * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.6F * em, 0.5F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 0.6F * em);
  ImGui::SetCursorScreenPos(ImVec2(left_px, 0));
  ImGui::BeginChild("panel", ImVec2(gui.width() - left_px, gui.height()), false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
}

Panel::~Panel() {
  ImGui::EndChild();
  ImGui::PopStyleVar(kSizes);
  ImGui::PopStyleColor(static_cast<int>(kStyleColours.size()));
  ImGui::PopFont();
}

void panel_tooltip(const std::string& text) {
  constexpr float kWidthEm = 20.0F;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    return;
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kWidthEm * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void panel_heading(const char* name) {
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::TextDisabled("%s", name);
}

bool panel_section(const char* name, bool open_at_first) {
  ImGui::Spacing();
  return ImGui::CollapsingHeader(name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void panel_label(const char* name) {
  constexpr float kLabelEm = 8.5F;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(kLabelEm * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(-1.0F);
}

void panel_row(const std::string& name, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(value.c_str());
}

bool panel_box(const char* name, bool& value, const char* tooltip) {
  const bool changed = ImGui::Checkbox(name, &value);
  panel_tooltip(tooltip);
  return changed;
}

std::optional<std::size_t> clicked_name(const char* id, const std::string& shown,
                                        const std::vector<std::string>& names) {
  std::optional<std::size_t> clicked;
  if (ImGui::BeginCombo(id, shown.c_str())) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (ImGui::Selectable(names[i].c_str(), names[i] == shown)) {
        clicked = i;
      }
    }
    ImGui::EndCombo();
  }
  return clicked;
}

bool chosen_name(const char* label, std::string& chosen, const std::vector<std::string>& names,
                 const char* tooltip) {
  panel_label(label);
  ImGui::PushID(label);
  const auto clicked = clicked_name("##choice", chosen, names);
  ImGui::PopID();
  panel_tooltip(tooltip);
  chosen = clicked ? names[*clicked] : chosen;
  return clicked.has_value();
}

}  // namespace impetus::inline viewers
