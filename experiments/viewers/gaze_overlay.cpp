// SPDX-License-Identifier: MIT
#include "experiments/viewers/gaze_overlay.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/gaze/region_source.hpp"

namespace impetus::inline viewers {
namespace {

constexpr ImU32 kGazeColour = IM_COL32(20, 70, 30, 255);
constexpr ImU32 kHalo = IM_COL32(255, 255, 255, 150);  ///< sets it off from dark bodies
constexpr float kThickness = 1.5F;
constexpr float kTrailThickness = 3.0F;
constexpr ImU32 kLostColour = IM_COL32(132, 44, 24, 255);

/// Fresh: 1, faded: 0.
ImU32 trail_ink(double freshness) {
  return IM_COL32(20, 110, 40, static_cast<int>(40.0 + 190.0 * std::clamp(freshness, 0.0, 1.0)));
}

/// Small, on a ground of its own.
void write_beside(ImDrawList& draw, const WindowPoint& place, const char* words) {
  constexpr float kShareOfBody = 0.64F;
  ImFont* font = ImGui::GetFont();
  const float size_px = std::round(kShareOfBody * ImGui::GetFontSize());
  const ImVec2 from(std::round(place.x + 12.0F), std::round(place.y + 9.0F));
  const ImVec2 size = font->CalcTextSizeA(size_px, 1e6F, 0.0F, words);
  draw.AddRectFilled(ImVec2(from.x - 3.0F, from.y - 1.0F),
                     ImVec2(from.x + size.x + 3.0F, from.y + size.y + 1.0F), kHalo, 2.0F);
  draw.AddText(font, size_px, from, kLostColour, words);
}

/// None: it goes away from the glass.
std::optional<Vector3> where_it_meets_the_glass(const Viewer& viewer, const Vector3& direction) {
  const double ahead = -direction.dot(viewer.right.cross(viewer.up));
  constexpr double kAlong = 1e-9;
  if (ahead <= kAlong) {
    return std::nullopt;
  }
  return viewer.eye + viewer.screen.viewing_distance_m / ahead * direction;
}

}  // namespace

void draw_gaze(const PictureMap& map, const Viewer& own, const ScreenPoint& fixation) {
  constexpr float kArm = 7.0F;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto seen = map.seen(on_screen(own, fixation));
  if (!seen) {
    return;
  }
  const WindowPoint at = *seen;
  const auto cross = [&](float arm, ImU32 colour, float thickness) {
    draw.AddLine(ImVec2(at.x - arm, at.y), ImVec2(at.x + arm + 1, at.y), colour, thickness);
    draw.AddLine(ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm + 1), colour, thickness);
  };
  cross(kArm + 1.5F, kHalo, kThickness + 3.0F);
  cross(kArm, kGazeColour, kThickness);
}

void draw_region(const PictureMap& map, const Viewer& own, const GazeRegion& region) {
  constexpr int kCorners = 72;
  if (region.radius_deg >= kWholeView_deg) {
    return;
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Vector3 ahead = (on_screen(own, region.centre) - own.eye).normalized();
  const Vector3 across = ahead.cross(own.up).normalized();
  const Vector3 along = across.cross(ahead);
  const SineCosine radius = sine_cosine_deg(region.radius_deg);
  for (int corner = 0; corner < kCorners; ++corner) {
    const SineCosine round = sine_cosine_deg(360.0 * corner / kCorners);
    const Vector3 direction =
        radius.cosine * ahead + radius.sine * (round.cosine * across + round.sine * along);
    const auto on_glass = where_it_meets_the_glass(own, direction);
    const auto point = on_glass ? map.seen(*on_glass) : std::nullopt;
    if (point) {
      draw.PathLineTo(ImVec2(point->x, point->y));
    }
  }
  draw.PathStroke(kGazeColour, ImDrawFlags_Closed, kThickness);
}

void draw_trail(const PictureMap& map, const Viewer& own, const GazeTrail& trail) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::optional<WindowPoint> last;
  for (const TrailPoint& point : trail.points) {
    const auto at = map.seen(on_screen(own, point.at));
    const ImU32 ink = trail_ink(1.0 - point.age_s / kTrail_s);
    if (at && last && point.joined) {
      draw.AddLine(ImVec2(last->x, last->y), ImVec2(at->x, at->y), ink, kTrailThickness);
    }
    if (at) {
      draw.AddCircleFilled(ImVec2(at->x, at->y), 0.5F * kTrailThickness + 0.7F, ink);
    }
    last = at;
  }
  if (trail.lost != GazeLoss::kNone && last) {
    write_beside(draw, *last, word_of(trail.lost));
  }
}

}  // namespace impetus::inline viewers
