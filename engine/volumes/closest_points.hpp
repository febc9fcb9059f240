// Where two cores come closest.
//
// Of cores that are apart, the closest points are a corner and a point of the other core, or points
// of two edges: all of them are tried. Cores that meet are found by their separating axes first,
// since an edge may pierce the other core far from its edges. (Ericson 2005, sec. 5.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/volumes/core.hpp"

namespace impetus::inline volumes {

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
