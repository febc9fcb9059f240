// The lab's screen as it was entered, and whether its pixels are square: where they are taken for
// what they are not, balls become eggs and visual angles differ across and down.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline record {

/// What was measured, and what was said about it.
struct LabScreen {
  ScreenGeometry geometry;
  bool square_pixels{true};  ///< false: somebody said that this screen's pixels are not square
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

}  // namespace impetus::inline record
