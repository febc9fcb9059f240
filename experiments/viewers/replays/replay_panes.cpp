// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_panes.hpp"

#include <cmath>

#include "experiments/record/lab_screen.hpp"

namespace impetus::inline viewers {

float screen_margin(const Gui& gui) { return std::round(0.018F * gui.height()); }

float content_width(const Gui& gui) { return gui.width() - 2.0F * screen_margin(gui); }

std::vector<PixelArea> areas_of(const Panes& panes, const Gui& gui, const ScreenGeometry& screen) {
  const float margin = screen_margin(gui);
  const double gap_px = 0.5 * margin;
  const double wide_px = (content_width(gui) - (panes.count - 1) * gap_px) / panes.count;
  const double high_px = gui.height() - panes.header_px - panes.footer_px - 0.5F * margin;
  const PicturePixels largest = largest_picture(screen, wide_px, high_px);
  PixelArea area;
  area.width = largest.width;
  area.height = largest.height;
  area.bottom = static_cast<int>(panes.footer_px + 0.5F * margin + (high_px - area.height) / 2);
  const double whole_px = panes.count * area.width + (panes.count - 1) * gap_px;
  std::vector<PixelArea> areas;
  for (int pane = 0; pane < panes.count; ++pane) {
    area.left = static_cast<int>((gui.width() - whole_px) / 2 + pane * (area.width + gap_px));
    areas.push_back(area);
  }
  return areas;
}

}  // namespace impetus::inline viewers
