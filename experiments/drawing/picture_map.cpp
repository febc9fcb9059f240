// SPDX-License-Identifier: MIT
#include "experiments/drawing/picture_map.hpp"

#include <cmath>

namespace impetus::inline drawing {

Vector3 seen_direction(const Viewer& viewer, const Vector3& direction_W) {
  return {viewer.right.dot(direction_W), viewer.up.dot(direction_W),
          viewer.right.cross(viewer.up).dot(direction_W)};
}

Vector3 seen_from_eye(const Viewer& viewer, const Vector3& p_WP) {
  return seen_direction(viewer, p_WP - viewer.eye);
}

Matrix3 rotation_to_eye(const Viewer& viewer) {
  Matrix3 R_EW;
  R_EW << viewer.right.transpose(), viewer.up.transpose(),
      viewer.right.cross(viewer.up).transpose();
  return R_EW;
}

PictureMap::PictureMap(const Viewer& viewer, const PixelArea& area, int window_height_px)
    : viewer_(viewer),
      left_px_(area.left),
      top_px_(window_height_px - area.bottom - area.height),
      px_per_m_x_(area.width / viewer.screen.width_m),
      px_per_m_y_(area.height / viewer.screen.height_m) {}

std::optional<WindowPoint> PictureMap::seen(const Vector3& p_WP) const {
  constexpr double kNear_m = 0.01;
  const Vector3 from_eye = seen_from_eye(viewer_, p_WP);
  const double ahead_m = -from_eye.z();
  if (ahead_m < kNear_m) {
    return std::nullopt;
  }
  const ScreenGeometry& screen = viewer_.screen;
  const double scale = screen.viewing_distance_m / ahead_m;
  const double x = left_px_ + (0.5 * screen.width_m + scale * from_eye.x()) * px_per_m_x_;
  const double y = top_px_ + (0.5 * screen.height_m - scale * from_eye.y()) * px_per_m_y_;
  return WindowPoint{static_cast<float>(x), static_cast<float>(y)};
}

std::optional<ScreenPoint> PictureMap::glass_under(const WindowPoint& pixel) const {
  const double half_width_m = 0.5 * viewer_.screen.width_m;
  const double half_height_m = 0.5 * viewer_.screen.height_m;
  const ScreenPoint point{(pixel.x - left_px_) / px_per_m_x_ - half_width_m,
                          half_height_m - (pixel.y - top_px_) / px_per_m_y_};
  const bool within = std::abs(point.x_m) <= half_width_m && std::abs(point.y_m) <= half_height_m;
  return within ? std::optional<ScreenPoint>(point) : std::nullopt;
}

}  // namespace impetus::inline drawing
