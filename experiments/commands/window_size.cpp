// SPDX-License-Identifier: MIT
#include "experiments/commands/window_size.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {

WindowOptions window_options(const std::string& size) {
  WindowOptions options;
  if (size.empty()) {
    return options;
  }
  options.fullscreen = false;
  char rest = '\0';
  const int read =
      std::sscanf(size.c_str(), "%dx%d%c", &options.width_px, &options.height_px, &rest);
  if (read != 2 || options.width_px < 640 || options.height_px < 480) {
    throw InputError("--window " + size + ": expected WIDTHxHEIGHT of at least 640x480 pixels");
  }
  return options;
}

DisplayMode shown_mode(const WindowOptions& window) {
  DisplayMode mode = display_mode();
  if (!window.fullscreen) {
    mode.width_px = window.width_px;
    mode.height_px = window.height_px;
  }
  return mode;
}

int picture_px(const char* option, int asked, int usual) {
  if (asked < 0 || asked > kLargestPicturePx) {
    throw InputError(std::string(option) + ": expected from 1 to " +
                     std::to_string(kLargestPicturePx) + " pixels, got " + std::to_string(asked));
  }
  return asked == 0 ? usual : asked;
}

namespace {

int even(double side_px) { return 2 * std::max(1, static_cast<int>(std::lround(side_px / 2.0))); }

}  // namespace

PictureSize picture_size(int width_px, int height_px, const ScreenGeometry& screen) {
  constexpr int kUsualWidth_px = 1280;
  constexpr double kOffShape = 0.01;  // as much as nobody sees
  const bool known = screen.width_px > 0 && screen.height_px > 0;
  const double shape = known ? static_cast<double>(screen.width_px) / screen.height_px
                             : screen.width_m / screen.height_m;
  PictureSize size;
  const int usual_width_px = height_px > 0 ? even(shape * height_px)
                             : known       ? screen.width_px
                                           : kUsualWidth_px;
  size.width_px = picture_px("--width", width_px, usual_width_px);
  const bool is_own = size.width_px == screen.width_px && known;
  size.height_px =
      picture_px("--height", height_px, is_own ? screen.height_px : even(size.width_px / shape));
  const double off_px = std::abs(size.width_px - shape * size.height_px);
  if (off_px > std::max(2.0 * shape, kOffShape * size.width_px)) {
    throw InputError(
        printed("--width, --height: expected the shape of the screen, %.4g : 1, got %d x %d pixels",
                shape, size.width_px, size.height_px));
  }
  return size;
}

void require_picture_of_size(int width_px, int height_px, const std::string& pictures) {
  if (width_px != 0 || height_px != 0) {
    throw InputError(std::string(width_px != 0 ? "--width" : "--height") + ": expected " +
                     pictures + " beside it, which is missing");
  }
}

}  // namespace impetus::inline commands
