// Between places of the world, of the glass, and pixels of the window where a picture is painted.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline drawing {

/// A rectangle of the window in pixels, from its lower left corner.
struct PixelArea {
  int left{0};
  int bottom{0};
  int width{0};
  int height{0};
};

/// Pixels from the window's upper left corner.
struct WindowPoint {
  float x{0.0F};
  float y{0.0F};
};

/// A direction as the viewer sees it: right, up, and towards the viewer.
Vector3 seen_direction(const Viewer& viewer, const Vector3& direction_W);

/// A point as the viewer sees it, from the eye (metres).
Vector3 seen_from_eye(const Viewer& viewer, const Vector3& p_WP);

/// From the world's axes to those of seen_direction().
Matrix3 rotation_to_eye(const Viewer& viewer);

/// Where the points of a picture lie in the window, and back.
class PictureMap {
 public:
  /// The viewer's screen fills the area exactly. `window_height_px` is the whole window's.
  PictureMap(const Viewer& viewer, const PixelArea& area, int window_height_px);

  [[nodiscard]] const Viewer& viewer() const { return viewer_; }
  /// Where a point of the world is seen; nothing when it is not in front of the eye.
  [[nodiscard]] std::optional<WindowPoint> seen(const Vector3& p_WP) const;
  /// The point of the glass under a pixel; nothing outside the picture.
  [[nodiscard]] std::optional<ScreenPoint> glass_under(const WindowPoint& pixel) const;

 private:
  Viewer viewer_;
  double left_px_;
  double top_px_;
  double px_per_m_x_;
  double px_per_m_y_;
};

}  // namespace impetus::inline drawing
