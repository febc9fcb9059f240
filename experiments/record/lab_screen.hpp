// The lab's screen as it was entered: how large, how bright, and whether its pixels are square.
// Where they are taken for what they are not, balls become eggs and visual angles differ across and
// down.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline record {

/// How bright the screen is, by a photometer before it:
///
///   luminance = black + (white − black) · vᵞ,   v: a grey's value, from 0 to 1
struct ScreenLight {
  double black_cd_m2{0.0};
  double white_cd_m2{0.0};
  double gamma{2.2};  ///< γ
};

/// What a colour of these values, sRGB from 0 to 1, sends out in cd/m², each primary by its share
/// of white (ITU-R BT.709).
double luminance_cd_m2(const ScreenLight& light, const std::array<float, 3>& colour);

/// "black 0.3, white 120 cd/m², gamma 2.2".
std::string light_words(const ScreenLight& light);

/// What was measured, and what was said about it.
struct LabScreen {
  ScreenGeometry geometry;
  bool square_pixels{true};  ///< false: somebody said that this screen's pixels are not square
  std::optional<ScreenLight> light{};
};

/// Whether width and height of a pixel are at most 1 % apart.
bool has_square_pixels(const ScreenGeometry& screen);

/// "37.6 cm x 30.1 cm, 1280 x 1024 pixels, seen from 57.0 cm".
std::string screen_words(const ScreenGeometry& screen);

/// The size of a pixel: "0.196 mm wide and 0.279 mm high".
std::string pixel_words(const ScreenGeometry& screen);

/// Whether both are of one size and as many pixels, seen from one distance.
bool is_same_screen(const ScreenGeometry& a, const ScreenGeometry& b);

/// Pixels across and down.
struct PicturePixels {
  int width{0};
  int height{0};
};

/// The largest picture within `wide_px` and `high_px` that has as many pixels across for each one
/// down as the whole screen: so it looks in a part of a window as it does over all of it.
PicturePixels largest_picture(const ScreenGeometry& screen, double wide_px, double high_px);

/// The middle of a pixel, counted from the left and from the top.
inline ScreenPoint on_glass(const ScreenGeometry& screen, double x_px, double y_px) {
  return {((x_px + 0.5) / screen.width_px - 0.5) * screen.width_m,
          (0.5 - (y_px + 0.5) / screen.height_px) * screen.height_m};
}

}  // namespace impetus::inline record
