// How far two nodes are apart, and in which direction.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/collision/placed_tree.hpp"

namespace impetus {

struct NodeGap {
  double gap_m{0.0};                 ///< less than zero: how deep they overlap
  Vector3 normal{Vector3::UnitX()};  ///< unit, from b towards a; they are as far apart along it
};

/// Of the spheres that bound the nodes: never more than the nodes' own.
NodeGap gap_of_bounds(const Sphere& a, const Sphere& b);

/// Of the nodes themselves.
NodeGap gap_of_nodes(const Volume& a, const Volume& b);

}  // namespace impetus
