// SPDX-License-Identifier: MIT
#include "engine/scheduling/viewer.hpp"

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scheduling {

Viewer viewer_at(const ScreenGeometry& screen, double azimuth_deg, double elevation_deg) {
  const SineCosine turn = sine_cosine_deg(azimuth_deg);
  Viewer viewer;
  viewer.screen = screen;
  viewer.eye = screen.viewing_distance_m * Vector3(turn.sine, 0.0, turn.cosine);
  viewer.right = Vector3(turn.cosine, 0.0, -turn.sine);
  if (elevation_deg != 0.0) {  // a level eye keeps every bit, signs of zeros too
    const SineCosine raised = sine_cosine_deg(elevation_deg);
    const Vector3 level(turn.sine, 0.0, turn.cosine);
    viewer.eye =
        screen.viewing_distance_m * (raised.cosine * level + raised.sine * Vector3::UnitY());
    viewer.up = raised.cosine * Vector3::UnitY() - raised.sine * level;
  }
  return viewer;
}

ViewFrustum view_frustum(const Viewer& viewer, double front_m, double back_m) {
  return {viewer.eye,
          viewer.right,
          viewer.up,
          0.5 * viewer.screen.width_m,
          0.5 * viewer.screen.height_m,
          front_m,
          back_m};
}

Vector3 on_screen(const Viewer& viewer, const ScreenPoint& point) {
  return point.x_m * viewer.right + point.y_m * viewer.up;
}

std::optional<ScreenPoint> projected(const Viewer& viewer, const Vector3& point) {
  const double distance_m = viewer.eye.norm();
  const Vector3 ray = point - viewer.eye;
  const double depth_m = -ray.dot(viewer.eye) / distance_m;
  if (depth_m <= 0.0) {
    return std::nullopt;
  }
  const double scale = distance_m / depth_m;
  return ScreenPoint{scale * ray.dot(viewer.right), scale * ray.dot(viewer.up)};
}

double visual_angle_deg(const Viewer& viewer, const Vector3& p, const Vector3& q) {
  const Vector3 u = p - viewer.eye;
  const Vector3 w = q - viewer.eye;
  return degrees(atan2_rad(u.cross(w).norm(), u.dot(w)));
}

Vector3 seen_velocity(const Viewer& viewer, const Vector3& place, const Vector3& velocity) {
  const Vector3 from_eye = place - viewer.eye;
  return velocity - viewer.velocity - viewer.turning.cross(from_eye);
}

double angular_speed_deg_s(const Viewer& viewer, const Vector3& place, const Vector3& velocity) {
  const Vector3 from_eye = place - viewer.eye;
  const Vector3 seen = seen_velocity(viewer, place, velocity);
  return degrees(from_eye.cross(seen).norm() / from_eye.squaredNorm());
}

}  // namespace impetus::inline scheduling
