// SPDX-License-Identifier: MIT
#include "experiments/drawing/patch_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace impetus::inline drawing {

PixelArea patch_area(ScreenCorner corner, const ScreenGeometry& screen, int width_px,
                     int height_px) {
  const auto pixels = [](double side_m, int all_px) {
    return std::clamp(static_cast<int>(std::lround(kPatchSide_m / side_m * all_px)), 1, all_px);
  };
  PixelArea area{0, 0, pixels(screen.width_m, width_px), pixels(screen.height_m, height_px)};
  if (corner == ScreenCorner::kTopRight || corner == ScreenCorner::kBottomRight) {
    area.left = width_px - area.width;
  }
  if (corner == ScreenCorner::kTopLeft || corner == ScreenCorner::kTopRight) {
    area.bottom = height_px - area.height;
  }
  return area;
}

std::optional<std::int64_t> code_of_pixel(int red, int green, int blue) {
  constexpr int kTolerance = 8;  // dithering and colour depths of 5 or 6 bits change a grey by less
  for (std::int64_t code = 0; code < kPatchCodes; ++code) {
    const int grey = static_cast<int>(std::lround(255.0F * patch_grey(code)));
    if (std::max({std::abs(red - grey), std::abs(green - grey), std::abs(blue - grey)}) <=
        kTolerance) {
      return code;
    }
  }
  return std::nullopt;
}

}  // namespace impetus::inline drawing
