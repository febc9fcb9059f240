// A hinge: two parts of a figure that share a point and may turn about one axis through it.
//
//        child's core                angle    of the child's zero direction from the parent's,
//              /                              about the axis
//   parent's  o  <- anchor, axis     opening  between the two core axes, both away from the hinge:
//   core ____/                                180° straight, 0° folded
//
// (Dingliana 2002, sec. 4.1.3 and figure 4.8)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/dynamics/body.hpp"

namespace impetus::inline figures {

/// One part's side of a hinge, in that part's own frame.
struct HingeSide {
  Vector3 anchor{Vector3::Zero()};  ///< the shared point, from the centre of mass (metres)
  Vector3 axis{Vector3::UnitZ()};   ///< unit; the same direction in the world for both sides
  Vector3 zero{Vector3::UnitX()};   ///< unit, across the axis: where angles are measured from
  Vector3 core{Vector3::UnitX()};   ///< unit, along the part's core, away from the hinge
};

/// Angles in radians, within [−π, π]. Without limits it turns freely.
struct Hinge {
  std::int32_t child{0};   ///< a body's index in the world, as is
  std::int32_t parent{0};  ///< the other
  HingeSide of_child;
  HingeSide of_parent;
  double rest_rad{0.0};
  double least_rad{-std::numeric_limits<double>::infinity()};
  double most_rad{std::numeric_limits<double>::infinity()};
  /// θc: the two parts are said to collide where the opening between their cores is smaller than at
  /// rest by more than this (radians, above 0); infinite: never.
  double fold_rad{std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool is_limited() const {
    return least_rad > -std::numeric_limits<double>::infinity() ||
           most_rad < std::numeric_limits<double>::infinity();
  }
};

/// The angle at which the two poses hold the hinge (radians, within π of the middle of its limits).
double angle_of(const Hinge& hinge, const Pose& child, const Pose& parent);

/// The opening between the two cores (radians, 0 to π).
double opening_of(const Hinge& hinge, const Pose& child, const Pose& parent);

/// The opening at the rest angle.
double opening_at_rest(const Hinge& hinge);

/// Whether the cores are folded past the threshold.
bool is_folded(const Hinge& hinge, const Pose& child, const Pose& parent);

/// How far the two anchors are apart (metres).
double anchor_gap_m(const Hinge& hinge, const Pose& child, const Pose& parent);

/// The pose at which a child hangs from a parent so placed, at an angle.
Pose hung_from(const Hinge& hinge, const Pose& parent, double angle_rad);

/// What is wrong with a hinge alone, as "expected ..., got ..."; empty when nothing is.
std::string problem_of(const Hinge& hinge);

}  // namespace impetus::inline figures
