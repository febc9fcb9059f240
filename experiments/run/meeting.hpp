// Where two bodies that approach along x first touch, at a given level of their volume trees.
//
//        a ───>            <─── b        The pair of nodes that is reached first decides; its
//      ( o )( o )      ( o )( o )        contact point is put at x = 0, the screen's centre.
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/volume_tree.hpp"

namespace impetus::inline run {

/// The x coordinates (metres) of both centres of mass at first touch.
struct MeetingPlaces {
  double a_m{0.0};
  double b_m{0.0};
};

/// Two trees with their centres of mass on the x axis, a on the negative side. Nodes without
/// children stand in for deeper levels. `aside_b` (its x is 0) moves b's line of approach away from
/// the axis. When none can touch, the bounding spheres' places.
MeetingPlaces meeting_places(const VolumeTree& a, const Quaternion& orientation_a,
                             const VolumeTree& b, const Quaternion& orientation_b, int level,
                             const Vector3& aside_b = Vector3::Zero());

/// Whether any of their nodes touch on the way: otherwise they pass by.
bool can_meet(const VolumeTree& a, const Quaternion& orientation_a, const VolumeTree& b,
              const Quaternion& orientation_b, int level, const Vector3& aside_b);

}  // namespace impetus::inline run
