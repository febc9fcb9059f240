// SPDX-License-Identifier: MIT
#include "experiments/record/lab_screen.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline record {
namespace {

/// What a ruler on the glass can be trusted with.
constexpr double kSquareWithin = 0.01;

double pixel_width_m(const ScreenGeometry& screen) { return screen.width_m / screen.width_px; }
double pixel_height_m(const ScreenGeometry& screen) { return screen.height_m / screen.height_px; }

/// To the micrometre, as a screen file keeps it.
bool is_same_length(double a_m, double b_m) { return std::abs(a_m - b_m) < 1e-6; }

}  // namespace

double luminance_cd_m2(const ScreenLight& light, const std::array<float, 3>& colour) {
  constexpr std::array<double, 3> kShares{0.2126, 0.7152, 0.0722};
  double of_white = 0.0;
  for (std::size_t primary = 0; primary < 3; ++primary) {
    of_white += kShares[primary] * std::pow(colour[primary], light.gamma);
  }
  return light.black_cd_m2 + (light.white_cd_m2 - light.black_cd_m2) * of_white;
}

std::string light_words(const ScreenLight& light) {
  return printed("black %.4g, white %.4g cd/m², gamma %.4g", light.black_cd_m2, light.white_cd_m2,
                 light.gamma);
}

bool has_square_pixels(const ScreenGeometry& screen) {
  const double width_m = pixel_width_m(screen);
  const double height_m = pixel_height_m(screen);
  return std::max(width_m, height_m) <= (1.0 + kSquareWithin) * std::min(width_m, height_m);
}

std::string screen_words(const ScreenGeometry& screen) {
  return printed("%.1f cm x %.1f cm, %d x %d pixels, seen from %.1f cm", 100.0 * screen.width_m,
                 100.0 * screen.height_m, screen.width_px, screen.height_px,
                 100.0 * screen.viewing_distance_m);
}

std::string pixel_words(const ScreenGeometry& screen) {
  return printed("%.3f mm wide and %.3f mm high", 1e3 * pixel_width_m(screen),
                 1e3 * pixel_height_m(screen));
}

bool is_same_screen(const ScreenGeometry& a, const ScreenGeometry& b) {
  return is_same_length(a.width_m, b.width_m) && is_same_length(a.height_m, b.height_m) &&
         is_same_length(a.viewing_distance_m, b.viewing_distance_m) && a.width_px == b.width_px &&
         a.height_px == b.height_px;
}

PicturePixels largest_picture(const ScreenGeometry& screen, double wide_px, double high_px) {
  const double scale = std::min(wide_px / screen.width_px, high_px / screen.height_px);
  return {static_cast<int>(scale * screen.width_px), static_cast<int>(scale * screen.height_px)};
}

}  // namespace impetus::inline record
