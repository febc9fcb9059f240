// SPDX-License-Identifier: MIT
#include "experiments/stage/gaze_overlay.hpp"

#include <imgui.h>

#include "engine/numerics/trigonometry.hpp"
#include "experiments/session/region_source.hpp"

namespace impetus {
namespace {

constexpr ImU32 kGazeColour = IM_COL32(20, 70, 30, 255);
constexpr ImU32 kHalo = IM_COL32(255, 255, 255, 150);  ///< sets it off from dark bodies
constexpr float kThickness = 1.5F;

}  // namespace

void draw_gaze(const PictureMap& map, const ScreenPoint& fixation) {
  constexpr float kArm = 7.0F;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const WindowPoint at = map.at(fixation);
  const auto cross = [&](float arm, ImU32 colour, float thickness) {
    draw.AddLine(ImVec2(at.x - arm, at.y), ImVec2(at.x + arm + 1, at.y), colour, thickness);
    draw.AddLine(ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm + 1), colour, thickness);
  };
  cross(kArm + 1.5F, kHalo, kThickness + 3.0F);
  cross(kArm, kGazeColour, kThickness);
}

void draw_region(const PictureMap& map, const GazeRegion& region) {
  constexpr int kCorners = 72;
  if (region.radius_deg >= kWholeView_deg) {
    return;
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Viewer& viewer = map.viewer();
  const Vector3 ahead = (on_screen(viewer, region.centre) - viewer.eye).normalized();
  const Vector3 across = ahead.cross(viewer.up).normalized();
  const Vector3 along = across.cross(ahead);
  const SineCosine radius = sine_cosine_deg(region.radius_deg);
  for (int corner = 0; corner < kCorners; ++corner) {
    const SineCosine round = sine_cosine_deg(360.0 * corner / kCorners);
    const Vector3 direction =
        radius.cosine * ahead + radius.sine * (round.cosine * across + round.sine * along);
    if (const auto point = map.seen(viewer.eye + direction)) {
      draw.PathLineTo(ImVec2(point->x, point->y));
    }
  }
  draw.PathStroke(kGazeColour, ImDrawFlags_Closed, kThickness);
}

}  // namespace impetus
