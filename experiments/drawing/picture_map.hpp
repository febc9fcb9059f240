// Between places of the world, of the glass, and pixels of the window where a picture is painted.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/viewer.hpp"
#include "experiments/drawing/pixel_area.hpp"

namespace impetus::inline drawing {

/// Pixels from the window's upper left corner.
struct WindowPoint {
  float x{0.0F};
  float y{0.0F};
};

class PictureMap {
 public:
  /// The viewer's screen fills the area exactly. `window_height_px` is the whole window's.
  PictureMap(const Viewer& viewer, const PixelArea& area, int window_height_px);

  [[nodiscard]] const Viewer& viewer() const { return viewer_; }
  /// Where a point of the world is seen; nothing when it is not in front of the eye.
  [[nodiscard]] std::optional<WindowPoint> seen(const Vector3& p_WP) const;
  [[nodiscard]] WindowPoint at(const ScreenPoint& point) const;
  /// The point of the glass under a pixel; nothing outside the picture.
  [[nodiscard]] std::optional<ScreenPoint> glass_under(const WindowPoint& pixel) const;
  /// Pixels across that an angle about the centre of the screen spans.
  [[nodiscard]] float pixels_across(double angle_deg) const;

 private:
  Viewer viewer_;
  double left_px_;
  double top_px_;
  double px_per_m_x_;
  double px_per_m_y_;
};

}  // namespace impetus::inline drawing
