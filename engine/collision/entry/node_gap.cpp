// SPDX-License-Identifier: MIT
#include "engine/collision/entry/node_gap.hpp"

#include <cmath>
#include <optional>

#include "engine/volumes/core_contact.hpp"
#include "engine/volumes/core_distance.hpp"

namespace impetus::inline collision {

NodeGap gap_of_nodes(const Volume& a, const Volume& b) {
  const CoredVolume of_a = cored(a);
  const CoredVolume of_b = cored(b);
  const std::optional<ClosestOfCores> closest = closest_points(of_a.core, of_b.core);
  if (closest) {
    const double distance_m = std::sqrt(closest->squared_m2);
    return {distance_m - of_a.radius_m - of_b.radius_m,
            (closest->on_a - closest->on_b) / distance_m};
  }
  const TouchPoint touching = core_contact(of_a, of_b, Vector3::UnitX());
  return {-touching.depth_m, touching.normal};
}

}  // namespace impetus::inline collision
