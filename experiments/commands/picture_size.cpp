// SPDX-License-Identifier: MIT
#include "experiments/commands/picture_size.hpp"

#include <cmath>
#include <string>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

int picture_px(const char* option, int asked, int usual) {
  if (asked < 0 || asked > kLargestPicturePx) {
    throw InputError(std::string(option) + ": expected from 1 to " +
                     std::to_string(kLargestPicturePx) + " pixels, got " + std::to_string(asked));
  }
  return asked == 0 ? usual : asked;
}

PictureSize picture_size(int width_px, int height_px, const ScreenGeometry& screen) {
  constexpr int kUsualWidth_px = 1280;
  const int own_px = screen.width_px > 0 ? screen.width_px : kUsualWidth_px;
  const int wide_px = picture_px("--width", width_px, own_px);
  const double high_px = wide_px * screen.height_m / screen.width_m;
  const int usual_px = wide_px == screen.width_px && screen.height_px > 0
                           ? screen.height_px
                           : 2 * std::max(1, static_cast<int>(std::lround(high_px / 2.0)));
  return {wide_px, picture_px("--height", height_px, usual_px)};
}

}  // namespace impetus::inline commands
