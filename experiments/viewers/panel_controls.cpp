// SPDX-License-Identifier: MIT
#include "experiments/viewers/panel_controls.hpp"

namespace impetus::inline viewers {
namespace {

constexpr const char* kDragHint = " Drag to change, double-click to type.";
constexpr float kLabelEm = 8.5F;

}  // namespace

bool panel_section(const char* name, bool open_at_first) {
  ImGui::Spacing();
  return ImGui::CollapsingHeader(name, open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

void panel_label(const char* name) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(kLabelEm * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(-1.0F);
}

bool dragged_number(const char* id, double& value, float speed, double least, double most,
                    const char* format, const std::string& tooltip) {
  ImGui::SetNextItemWidth(-1.0F);
  const bool changed = ImGui::DragScalar(id, ImGuiDataType_Double, &value, speed, &least, &most,
                                         format, ImGuiSliderFlags_AlwaysClamp);
  panel_tooltip(tooltip + kDragHint);
  return changed;
}

bool dragged_number(const char* id, int& value, float speed, int least, int most,
                    const char* format, const std::string& tooltip) {
  ImGui::SetNextItemWidth(-1.0F);
  const bool changed =
      ImGui::DragInt(id, &value, speed, least, most, format, ImGuiSliderFlags_AlwaysClamp);
  panel_tooltip(tooltip + kDragHint);
  return changed;
}

void panel_box(const char* name, bool& value, const char* tooltip) {
  ImGui::Checkbox(name, &value);
  panel_tooltip(tooltip);
}

}  // namespace impetus::inline viewers
