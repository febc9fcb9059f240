// SPDX-License-Identifier: MIT
#include "engine/collision/node_gap.hpp"

#include <cmath>
#include <optional>

#include "engine/volumes/closest_points.hpp"
#include "engine/volumes/core_contact.hpp"

namespace impetus {

NodeGap gap_of_bounds(const Sphere& a, const Sphere& b) {
  const Vector3 offset = a.centre - b.centre;
  const double distance_m = offset.norm();
  NodeGap found;
  found.gap_m = distance_m - a.radius_m - b.radius_m;
  if (distance_m > 0.0) {
    found.normal = offset / distance_m;
  }
  return found;
}

NodeGap gap_of_nodes(const Volume& a, const Volume& b) {
  const CoredVolume of_a = cored(a);
  const CoredVolume of_b = cored(b);
  const std::optional<ClosestPoints> closest = closest_points(of_a.core, of_b.core);
  if (closest) {
    const double distance_m = std::sqrt(closest->squared_m2);
    return {distance_m - of_a.radius_m - of_b.radius_m,
            (closest->on_a - closest->on_b) / distance_m};
  }
  const TouchPoint touching = core_contact(of_a, of_b, Vector3::UnitX());
  return {-touching.depth_m, touching.normal};
}

}  // namespace impetus
