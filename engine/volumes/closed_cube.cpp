// SPDX-License-Identifier: MIT
#include "engine/volumes/closed_cube.hpp"

namespace impetus {
namespace {

/// How far along the wall's outward direction a point lies from the cube's centre.
double outward(int wall, const Vector3& point) {
  const double along = point[wall / 2];
  return wall % 2 == 0 ? along : -along;
}

}  // namespace

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
  TouchPoint result;
  result.normal = inward_normal(wall);
  result.depth_m = reach_beyond(cube, wall, sphere);
  result.point = sphere.centre;
  result.point[wall / 2] = wall % 2 == 0 ? cube.half_edge_m : -cube.half_edge_m;
  return result;
}

}  // namespace impetus
