// SPDX-License-Identifier: MIT
#include "engine/volumes/view_frustum.hpp"

#include <cmath>

namespace impetus::inline volumes {
namespace {

/// How far from unit length or from a right angle (cosine) the screen's axes may be.
constexpr double kSquare = 1e-9;

/// The points whose way along `outward` (unit) is `offset_m`.
struct WallPlane {
  Vector3 outward;
  double offset_m;

  [[nodiscard]] double height_m(const Vector3& point) const {
    return outward.dot(point) - offset_m;
  }
};

/// Through the eye and the edge of the screen that lies `half_m` along `side` (unit).
WallPlane plane_through_eye(const ViewFrustum& frustum, const Vector3& side, double half_m) {
  const Vector3 outward = (frustum.eye.squaredNorm() * side + half_m * frustum.eye).normalized();
  return {outward, outward.dot(frustum.eye)};
}

WallPlane plane_of(const ViewFrustum& frustum, int wall) {
  switch (wall) {
    case 0:
      return plane_through_eye(frustum, frustum.right, frustum.half_width_m);
    case 1:
      return plane_through_eye(frustum, -frustum.right, frustum.half_width_m);
    case 2:
      return plane_through_eye(frustum, frustum.up, frustum.half_height_m);
    case 3:
      return plane_through_eye(frustum, -frustum.up, frustum.half_height_m);
    case 4:
      return {frustum.eye.normalized(), frustum.front_m};
    default:
      return {-frustum.eye.normalized(), frustum.back_m};
  }
}

TouchPoint touch_below(const WallPlane& plane, const Vector3& place, double depth_m) {
  TouchPoint result;
  result.normal = -plane.outward;
  result.depth_m = depth_m;
  result.point = place - plane.height_m(place) * plane.outward;
  return result;
}

template <typename Shape>
bool reaches_any_wall(const ViewFrustum& frustum, const Shape& shape) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (reach_beyond(frustum, wall, shape) >= 0.0) {
      return true;
    }
  }
  return false;
}

bool is_square(const ViewFrustum& frustum) {
  const Vector3 forward = frustum.eye.normalized();
  return std::abs(frustum.right.norm() - 1.0) <= kSquare &&
         std::abs(frustum.up.norm() - 1.0) <= kSquare &&
         std::abs(frustum.right.dot(frustum.up)) <= kSquare &&
         std::abs(frustum.right.dot(forward)) <= kSquare &&
         std::abs(frustum.up.dot(forward)) <= kSquare;
}

}  // namespace

std::string problem_of(const ViewFrustum& frustum) {
  if (!(frustum.eye.norm() > 0.0) || !is_square(frustum)) {
    return "a view frustum needs a screen that faces the eye, with unit axes at right angles";
  }
  if (!(frustum.half_width_m > 0.0 && frustum.half_height_m > 0.0)) {
    return "a view frustum needs a screen of positive width and height";
  }
  if (!(frustum.front_m < frustum.eye.norm())) {
    return "a view frustum needs a front between the screen and the eye";
  }
  return frustum.back_m > -frustum.front_m ? "" : "a view frustum needs a back behind its front";
}

double reach_beyond(const ViewFrustum& frustum, int wall, const Sphere& sphere) {
  return plane_of(frustum, wall).height_m(sphere.centre) + sphere.radius_m;
}

double reach_beyond(const ViewFrustum& frustum, int wall, const Volume& volume) {
  if (const auto* sphere = std::get_if<Sphere>(&volume)) {
    return reach_beyond(frustum, wall, *sphere);
  }
  const CoredVolume whole = cored(volume);
  const WallPlane plane = plane_of(frustum, wall);
  return plane.height_m(whole.core.centre) + reach_along(whole.core, plane.outward) +
         whole.radius_m;
}

bool reaches_wall(const ViewFrustum& frustum, const Sphere& sphere) {
  return reaches_any_wall(frustum, sphere);
}

bool reaches_wall(const ViewFrustum& frustum, const Volume& volume) {
  return reaches_any_wall(frustum, volume);
}

Vector3 inward_normal(const ViewFrustum& frustum, int wall) {
  return -plane_of(frustum, wall).outward;
}

TouchPoint touch_wall(const ViewFrustum& frustum, int wall, const Sphere& sphere) {
  return touch_below(plane_of(frustum, wall), sphere.centre, reach_beyond(frustum, wall, sphere));
}

TouchPoint touch_wall(const ViewFrustum& frustum, int wall, const Volume& volume) {
  const WallPlane plane = plane_of(frustum, wall);
  const Core core = cored(volume).core;
  const Vector3 place =
      std::holds_alternative<Cube>(volume) ? core.centre : furthest_part(core, plane.outward);
  return touch_below(plane, place, reach_beyond(frustum, wall, volume));
}

Vector3 corner(const ViewFrustum& frustum, int index) {
  const double distance_m = frustum.eye.norm();
  const double depth_m = (index & 4) != 0 ? frustum.back_m : -frustum.front_m;
  const double scale = (distance_m + depth_m) / distance_m;
  const double across_m = (index & 1) != 0 ? frustum.half_width_m : -frustum.half_width_m;
  const double above_m = (index & 2) != 0 ? frustum.half_height_m : -frustum.half_height_m;
  return scale * (across_m * frustum.right + above_m * frustum.up) -
         depth_m / distance_m * frustum.eye;
}

}  // namespace impetus::inline volumes
