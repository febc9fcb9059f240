// SPDX-License-Identifier: MIT
#include "experiments/window/fixation_target.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline window {
namespace {

constexpr double kDisc_deg = 0.6;  ///< across
constexpr double kDot_deg = 0.2;   ///< as is the cross's thickness
constexpr ImU32 kDark = IM_COL32(24, 24, 26, 255);
constexpr ImU32 kLight = IM_COL32(128, 128, 128, 255);  ///< the picture's own grey

}  // namespace

void draw_fixation_target(const Gui& gui, const ScreenGeometry& screen, const ScreenPoint& at) {
  const double px_per_deg =
      gui.width() / screen.width_m * metres_per_degree(screen.viewing_distance_m);
  const auto radius = std::max(7.0F, static_cast<float>(px_per_deg * kDisc_deg / 2.0));
  const auto dot = std::max(2.5F, static_cast<float>(px_per_deg * kDot_deg / 2.0));
  const ImVec2 centre(static_cast<float>((at.x_m / screen.width_m + 0.5) * gui.width()),
                      static_cast<float>((0.5 - at.y_m / screen.height_m) * gui.height()));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled(centre, radius, kDark);
  draw.AddRectFilled(ImVec2(centre.x - radius - 1.0F, centre.y - dot),
                     ImVec2(centre.x + radius + 1.0F, centre.y + dot), kLight);
  draw.AddRectFilled(ImVec2(centre.x - dot, centre.y - radius - 1.0F),
                     ImVec2(centre.x + dot, centre.y + radius + 1.0F), kLight);
  draw.AddCircleFilled(centre, dot, kDark);
}

}  // namespace impetus::inline window
