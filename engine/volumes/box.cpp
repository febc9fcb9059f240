// SPDX-License-Identifier: MIT
#include "engine/volumes/box.hpp"

#include <cmath>

namespace impetus::inline volumes {

Sphere bounding_sphere(const Box& box) { return {box.centre, box.half_extents_m.norm()}; }

CoredVolume cored(const Box& box) {
  return {block_core(box.centre, box.orientation.toRotationMatrix(), box.half_extents_m), 0.0};
}

Box placed(const Box& box, const Pose& pose) {
  return {pose.transform(box.centre), box.half_extents_m, pose.orientation * box.orientation};
}

bool holds(const Box& box, const Vector3& point) {
  const Vector3 within = box.orientation.conjugate() * (point - box.centre);
  return (within.cwiseAbs().array() <= box.half_extents_m.array()).all();
}

double content_m3(const Box& box) { return 8.0 * box.half_extents_m.prod(); }

Sphere bounding_sphere(const Cube& cube) {
  return {cube.centre, std::sqrt(3.0) * cube.half_edge_m};
}

CoredVolume cored(const Cube& cube) {
  return cored(Box{cube.centre, Vector3::Constant(cube.half_edge_m), cube.orientation});
}

Cube placed(const Cube& cube, const Pose& pose) {
  return {pose.transform(cube.centre), cube.half_edge_m, pose.orientation * cube.orientation};
}

bool holds(const Cube& cube, const Vector3& point) {
  const Vector3 within = cube.orientation.conjugate() * (point - cube.centre);
  return within.cwiseAbs().maxCoeff() <= cube.half_edge_m;
}

double content_m3(const Cube& cube) {
  return 8.0 * cube.half_edge_m * (cube.half_edge_m * cube.half_edge_m);
}

}  // namespace impetus::inline volumes
