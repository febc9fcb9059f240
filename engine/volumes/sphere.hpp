// The sphere: the volume of a sphere-tree's node, and a shape of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/volumes/core.hpp"

namespace impetus::inline volumes {

/// All points within `radius_m` of the centre.
struct Sphere {
  Vector3 centre{Vector3::Zero()};
  double radius_m{0.0};
};

Sphere bounding_sphere(const Sphere& sphere);
CoredVolume cored(const Sphere& sphere);
Sphere placed(const Sphere& sphere, const Pose& pose);
bool holds(const Sphere& sphere, const Vector3& point);
double content_m3(const Sphere& sphere);

/// Whether two spheres overlap or touch.
inline bool overlap(const Sphere& a, const Sphere& b) {
  const double reach = a.radius_m + b.radius_m;
  return (a.centre - b.centre).squaredNorm() <= reach * reach;
}

/// Where two volumes meet: `point` in world, `normal` unit and from b towards a, `depth_m` the
/// overlap along it (negative when apart).
struct TouchPoint {
  Vector3 point{Vector3::Zero()};
  Vector3 normal{Vector3::UnitX()};
  double depth_m{0.0};
};

/// Contact of two spheres (Dingliana 2002, eq. 3.7 and 3.8, corrected). The normal runs from b to
/// a. The point divides the line of the centres in the ratio of the radii, which keeps it between
/// them; it lies on the plane of intersection only for equal or tangent spheres.
/// `normal_if_coincident` (unit) is used when the centres coincide.
TouchPoint touch(const Sphere& a, const Sphere& b, const Vector3& normal_if_coincident);

}  // namespace impetus::inline volumes
