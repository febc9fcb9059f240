// SPDX-License-Identifier: MIT
#include "experiments/window/point_map.hpp"

#include <cmath>

#include "experiments/drawing/palette.hpp"
#include "experiments/window/pages/page_layout.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline window {
namespace {

constexpr float kHeightShare = 0.26F;  // of the window's
constexpr float kPointRadius = 0.28F;  // of a letter's height
constexpr ImU32 kScreenColour = IM_COL32(128, 128, 128, 255);

void draw_point(ImDrawList& draw, ImVec2 shown, float radius) {
  draw.AddCircle(shown, radius, palette::kText, 0, 1.5F);
}

void draw_gaze_at(ImDrawList& draw, ImVec2 shown, ImVec2 gaze, float radius) {
  draw.AddLine(shown, gaze, palette::kOnAccent, 1.5F);
  draw.AddCircleFilled(gaze, 0.6F * radius, palette::kOnAccent);
}

}  // namespace

void draw_point_map(const Gui& gui, const PointMap& map) {
  if (map.points.empty()) {
    return;
  }
  const Column column = reading_column(gui);
  const float height = std::round(kHeightShare * gui.height());
  const float width = std::round(height * static_cast<float>(map.aspect));
  const ImVec2 corner(column.left, ImGui::GetCursorScreenPos().y + std::round(0.4F * part_gap()));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, ImVec2(corner.x + width, corner.y + height), kScreenColour);
  const auto place = [&](double x, double y) {
    return ImVec2(corner.x + width * static_cast<float>(0.5 + x),
                  corner.y + height * static_cast<float>(0.5 - y));
  };
  const float radius = kPointRadius * ImGui::GetFontSize();
  draw.PushClipRect(corner, ImVec2(corner.x + width, corner.y + height), true);
  for (const LookedAtPoint& point : map.points) {
    const ImVec2 shown = place(point.x, point.y);
    draw_point(draw, shown, radius);
    if (point.seen) {
      draw_gaze_at(draw, shown, place(point.gaze_x, point.gaze_y), radius);
    }
  }
  draw.PopClipRect();
  ImGui::SetCursorScreenPos(ImVec2(column.left, corner.y + height + std::round(0.3F * part_gap())));
  draw_text("Circles: the points. Light dots: the gaze.", gui.fonts().small, palette::kQuietText,
            column.width, Align::kLeft);
}

}  // namespace impetus::inline window
