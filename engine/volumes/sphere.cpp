// SPDX-License-Identifier: MIT
#include "engine/volumes/sphere.hpp"

#include <numbers>

namespace impetus::inline volumes {

Sphere bounding_sphere(const Sphere& sphere) { return sphere; }

CoredVolume cored(const Sphere& sphere) { return {point_core(sphere.centre), sphere.radius_m}; }

Sphere placed(const Sphere& sphere, const Pose& pose) {
  return {pose.transform(sphere.centre), sphere.radius_m};
}

bool holds(const Sphere& sphere, const Vector3& point) {
  return (point - sphere.centre).squaredNorm() <= sphere.radius_m * sphere.radius_m;
}

double content_m3(const Sphere& sphere) {
  return 4.0 / 3.0 * std::numbers::pi * sphere.radius_m * (sphere.radius_m * sphere.radius_m);
}

TouchPoint touch(const Sphere& a, const Sphere& b, const Vector3& normal_if_coincident) {
  const Vector3 b_to_a = a.centre - b.centre;
  const double distance = b_to_a.norm();
  const double reach = a.radius_m + b.radius_m;
  TouchPoint result;
  result.normal = distance > 0.0 ? Vector3(b_to_a / distance) : normal_if_coincident;
  result.point = reach > 0.0 ? Vector3((b.radius_m * a.centre + a.radius_m * b.centre) / reach)
                             : Vector3(0.5 * (a.centre + b.centre));
  result.depth_m = reach - distance;
  return result;
}

}  // namespace impetus::inline volumes
