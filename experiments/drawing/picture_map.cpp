// SPDX-License-Identifier: MIT
#include "experiments/drawing/picture_map.hpp"

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/drawing/sphere_image.hpp"

namespace impetus::inline drawing {

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
  const double scale = viewer_.screen.viewing_distance_m / ahead_m;
  return at({scale * from_eye.x(), scale * from_eye.y()});
}

WindowPoint PictureMap::at(const ScreenPoint& point) const {
  const double x = left_px_ + (0.5 * viewer_.screen.width_m + point.x_m) * px_per_m_x_;
  const double y = top_px_ + (0.5 * viewer_.screen.height_m - point.y_m) * px_per_m_y_;
  return {static_cast<float>(x), static_cast<float>(y)};
}

std::optional<ScreenPoint> PictureMap::glass_under(const WindowPoint& pixel) const {
  const double half_width_m = 0.5 * viewer_.screen.width_m;
  const double half_height_m = 0.5 * viewer_.screen.height_m;
  const ScreenPoint point{(pixel.x - left_px_) / px_per_m_x_ - half_width_m,
                          half_height_m - (pixel.y - top_px_) / px_per_m_y_};
  const bool within = std::abs(point.x_m) <= half_width_m && std::abs(point.y_m) <= half_height_m;
  return within ? std::optional<ScreenPoint>(point) : std::nullopt;
}

float PictureMap::pixels_across(double angle_deg) const {
  const SineCosine half = sine_cosine_deg(0.5 * angle_deg);
  const double length_m = 2.0 * viewer_.screen.viewing_distance_m * half.sine / half.cosine;
  return static_cast<float>(length_m * px_per_m_x_);
}

}  // namespace impetus::inline drawing
