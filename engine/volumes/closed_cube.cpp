// SPDX-License-Identifier: MIT
#include "engine/volumes/closed_cube.hpp"

namespace impetus::inline volumes {
namespace {

/// How far along the wall's outward direction a point lies from the cube's centre.
double outward(int wall, const Vector3& point) {
  const double along = point[wall / 2];
  return wall % 2 == 0 ? along : -along;
}

TouchPoint touch_below(const ClosedCube& cube, int wall, const Vector3& point, double depth_m) {
  TouchPoint result;
  result.normal = inward_normal(wall);
  result.depth_m = depth_m;
  result.point = point;
  result.point[wall / 2] = wall % 2 == 0 ? cube.half_edge_m : -cube.half_edge_m;
  return result;
}

}  // namespace

std::string problem_of(const ClosedCube& cube) {
  return cube.half_edge_m > 0.0 ? "" : "an enclosure needs a positive half edge";
}

double reach_beyond(const ClosedCube& cube, int wall, const Sphere& sphere) {
  return outward(wall, sphere.centre) + sphere.radius_m - cube.half_edge_m;
}

bool reaches_wall(const ClosedCube& cube, const Sphere& sphere) {
  return sphere.centre.cwiseAbs().maxCoeff() + sphere.radius_m >= cube.half_edge_m;
}

Vector3 inward_normal(int wall) {
  Vector3 normal = Vector3::Zero();
  normal[wall / 2] = wall % 2 == 0 ? -1.0 : 1.0;
  return normal;
}

TouchPoint touch_wall(const ClosedCube& cube, int wall, const Sphere& sphere) {
  return touch_below(cube, wall, sphere.centre, reach_beyond(cube, wall, sphere));
}

double reach_beyond(const ClosedCube& cube, int wall, const Volume& volume) {
  if (const auto* sphere = std::get_if<Sphere>(&volume)) {
    return reach_beyond(cube, wall, *sphere);
  }
  const CoredVolume whole = cored(volume);
  return outward(wall, whole.core.centre) + reach_along(whole.core, inward_normal(wall)) +
         whole.radius_m - cube.half_edge_m;
}

bool reaches_wall(const ClosedCube& cube, const Volume& volume) {
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (reach_beyond(cube, wall, volume) >= 0.0) {
      return true;
    }
  }
  return false;
}

TouchPoint touch_wall(const ClosedCube& cube, int wall, const Volume& volume) {
  const Core core = cored(volume).core;
  const Vector3 point = std::holds_alternative<Cube>(volume)
                            ? core.centre
                            : furthest_part(core, -inward_normal(wall));
  return touch_below(cube, wall, point, reach_beyond(cube, wall, volume));
}

Vector3 corner(const ClosedCube& cube, int index) {
  const auto side = [&](int axis) {
    return (index >> axis & 1) != 0 ? cube.half_edge_m : -cube.half_edge_m;
  };
  return {side(0), side(1), side(2)};
}

}  // namespace impetus::inline volumes
