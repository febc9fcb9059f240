// How far two nodes are apart, and in which direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/collision/placed_tree.hpp"

namespace impetus::inline collision {

/// The gap between two nodes.
struct NodeGap {
  double gap_m{0.0};                 ///< less than zero: how deep they overlap
  Vector3 normal{Vector3::UnitX()};  ///< unit, from b towards a; they are as far apart along it
};

/// Of the spheres that bound the nodes: never more than the nodes' own.
inline NodeGap gap_of_bounds(const Sphere& a, const Sphere& b) {
  const Vector3 offset = a.centre - b.centre;
  const double distance_m = offset.norm();
  NodeGap found;
  found.gap_m = distance_m - a.radius_m - b.radius_m;
  if (distance_m > 0.0) {
    found.normal = offset / distance_m;
  }
  return found;
}

/// Of the nodes themselves.
NodeGap gap_of_nodes(const Volume& a, const Volume& b);

}  // namespace impetus::inline collision
