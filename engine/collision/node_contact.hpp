// The contact of two overlapping nodes, and what the reductions weigh it by.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline collision {

/// Of a node of a and a node of b, or a node of a and a wall, which is one group and solid.
struct NodeContact {
  TouchPoint touch;
  double approach_m_s{0.0};      ///< of the bodies' points there along the normal; < 0: they part
  double since_entry_s{0.0};     ///< see time_since_entry_s()
  double node_m{0.0};            ///< radius that bounds the smaller of the two nodes
  double interpenetration{1.0};  ///< κ, from 0, touching, to 1, nested (eq. 4.3, corrected)
  double occupancy_a{1.0};       ///< share of the node that is solid
  double occupancy_b{1.0};
  std::int32_t group_a{kNoGroup};
  std::int32_t group_b{kNoGroup};
  Vector3 outward_a{Vector3::Zero()};  ///< density normal in world; zero where there is none
  Vector3 outward_b{Vector3::Zero()};
};

/// How likely it is that the solids meet where the nodes do: κ ρ_a ρ_b. (Dingliana 2002, eq. 4.6)
inline double collision_probability(const NodeContact& contact) {
  return contact.interpenetration * contact.occupancy_a * contact.occupancy_b;
}

/// How long ago two nodes of `reach_m` (sum of their half widths along the normal) began to overlap
/// when they moved at `speed_m_s`, of which `approach_m_s` along the normal: exact for spheres,
///   |(reach − depth) n − v t| = reach,
/// and depth over approach, the form of Dingliana 2002, sec. 4.2.1, corrected, where depth is
/// small. That form has no bound for nodes that slide past each other, which this has. Zero when
/// nothing moves.
double time_since_entry_s(double reach_m, double depth_m, double approach_m_s, double speed_m_s);

}  // namespace impetus::inline collision
