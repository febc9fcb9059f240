// SPDX-License-Identifier: MIT
#include "engine/volumes/sphere.hpp"

namespace impetus {

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

}  // namespace impetus
