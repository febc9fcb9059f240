// SPDX-License-Identifier: MIT
#include "experiments/viewers/panel_style.hpp"

#include <array>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

struct ColourOf {
  ImGuiCol what;
  ImU32 colour;
};

constexpr ImU32 kPressed = IM_COL32(190, 202, 214, 255);
constexpr ImU32 kGrab = IM_COL32(148, 170, 192, 255);  ///< a number can be read on it

constexpr std::array<ColourOf, 18> kStyleColours{
    {{ImGuiCol_ChildBg, palette::kPage},
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
     {ImGuiCol_ScrollbarBg, palette::kPage},
     {ImGuiCol_ScrollbarGrabHovered, palette::kQuietText},
     {ImGuiCol_ScrollbarGrabActive, palette::kAccent}}};

constexpr int kSizes = 6;

}  // namespace

PanelStyle::PanelStyle(ImFont* font) {
  const float em = font->FontSize;
  ImGui::PushFont(font);
  for (const ColourOf& each : kStyleColours) {
    ImGui::PushStyleColor(each.what, each.colour);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.35F * em, 0.2F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.45F * em, 0.34F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, ImVec2(0.4F * em, 0.3F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 0.2F * em);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.6F * em, 0.5F * em));
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 0.6F * em);
}

PanelStyle::~PanelStyle() {
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

}  // namespace impetus::inline viewers
