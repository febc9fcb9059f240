// Boxes: of any sides and orientation, and the cube of a voxel tree.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/volumes/sphere.hpp"

namespace impetus::inline volumes {

/// The points centre + R x with |x_i| ≤ half_extents_m[i], R the matrix of `orientation` (unit).
struct Box {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_extents_m{Vector3::Zero()};
  Quaternion orientation{Quaternion::Identity()};
};

/// A box of equal sides. Two of them touch as the spheres do that circumscribe them (Dingliana
/// 2002, sec. 4.1.2); overlaps, and contacts with other kinds, are a box's.
struct Cube {
  Vector3 centre{Vector3::Zero()};
  double half_edge_m{0.0};
  Quaternion orientation{Quaternion::Identity()};
};

Sphere bounding_sphere(const Box& box);
CoredVolume cored(const Box& box);
Box placed(const Box& box, const Pose& pose);
bool holds(const Box& box, const Vector3& point);
double content_m3(const Box& box);

Sphere bounding_sphere(const Cube& cube);
CoredVolume cored(const Cube& cube);
Cube placed(const Cube& cube, const Pose& pose);
bool holds(const Cube& cube, const Vector3& point);
double content_m3(const Cube& cube);

}  // namespace impetus::inline volumes
