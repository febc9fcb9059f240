// How far two cores are apart, and where they come closest.
//
// Whether they meet is told by the fifteen axes that tell whether blocks meet: three of either
// frame, and the nine products of one's axis and the other's (Gottschalk et al. 1996). A core of
// fewer dimensions is a block without thickness, so the same axes decide. The three axes of both
// frames alone, six, would be conservative too (Dingliana 2002, sec. 4.1.2, corrected); fifteen are
// exact. A gap counts only when it exceeds what rounding can make of a touch.
//
// Of cores that are apart, the closest points are a corner and a point of the other core, or points
// of two edges: all of them are tried. Cores that meet are found by their separating axes first,
// since an edge may pierce the other core far from its edges. (Ericson 2005, sec. 5.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/volumes/core.hpp"

namespace impetus::inline volumes {

/// What rounding can do to a distance between the cores (metres).
double rounding_slack_m(const Core& a, const Core& b);

/// Whether some axis shows the cores to be more than `distance_m` apart. They may be so without
/// it: then the nearest points are two corners, or a corner and an edge.
bool are_separated(const Core& a, const Core& b, double distance_m);

/// How far the cores are apart along `direction` (unit), at least; negative when they are not.
double gap_along(const Core& a, const Core& b, const Vector3& direction);

/// How cores that meet can be parted.
struct Penetration {
  Vector3 axis{Vector3::UnitX()};  ///< unit; its sense means nothing
  double depth_m{0.0};             ///< the way along the axis that parts the cores
};

/// The axis along which cores that meet are parted by the shortest way; of equal ones the first,
/// axes of a's frame before those of b's before products.
Penetration least_penetration(const Core& a, const Core& b);

/// Two points, one on each core, that no other two are closer than.
struct ClosestOfCores {
  Vector3 on_a{Vector3::Zero()};
  Vector3 on_b{Vector3::Zero()};
  double squared_m2{0.0};  ///< of their distance
};

/// The closest points, one pair of them when there are several. None when the cores share a point,
/// or come so close that the direction between them is lost in rounding.
std::optional<ClosestOfCores> closest_points(const Core& a, const Core& b);

/// Whether the cores come within `distance_m`. Never denied to cores that do: "no" is said only
/// with a direction along which they are further apart.
bool come_within(const Core& a, const Core& b, double distance_m);

}  // namespace impetus::inline volumes
