// How far two nodes are apart, and in which direction; and which spheres of two bodies on their
// ways could touch within a time, without asking when.
//
//   |<-- gap -->|         a and b approach by no more than speed · time + turning · time: what is
//  (a)         (b)        further apart does not touch
//
// Both answers are to the safe side by a margin far above rounding: what they rule out, the time of
// the pair's own formula (time_of_entry.cpp) rules out too. So a search that leaves it out finds
// the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/collision/entry/body_path.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/collision/sphere_block.hpp"

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

/// How fast points of a block's spheres can move by their body's turning (metres a step).
struct BlockTurning {
  LaneValues a;  ///< by row
  LaneValues b;  ///< by column
};

/// Rules out spheres of two bodies that go a stretch of their ways.
class NearSpheres {
 public:
  /// Bodies in a stretch of their ways, all points of which stay within the reaches of their
  /// centres of mass (metres).
  void enter(const RelativeStretch& stretch, double reach_a_m, double reach_b_m);

  /// Whether the poses are such that the reaches hold: they are numbers, turn without stretching
  /// and are not so far off that rounding counts. Else nothing is ruled out.
  void place(const Pose& a, const Pose& b);

  /// The pairs of a block that could touch by more than `hair_m` within `time`: of the others
  /// apart_for() is true. Finds how fast the points of each sphere move by their body's turning.
  [[nodiscard]] std::uint64_t within(double time, double hair_m, const SphereBlock& block,
                                     BlockTurning& turning, LaneWidth width = widest_lanes()) const;

  /// Whether two spheres cannot, by the way the bodies move: with the offset o, its length d and
  ///   q = d² − time max(0, −o·v),   R = r_a + r_b − hair + margin + time turning,
  /// (d − R) d ≥ time max(0, −o·v) where q ≥ R d, which is q² ≥ R² d² when neither is negative.
  [[nodiscard]] bool apart_for(double time, double hair_m, const Sphere& a, const Sphere& b,
                               double turning_m) const {
    const double margin = margin_m(time);
    const Vector3 offset = a.centre - b.centre;
    const double square_m2 = offset.squaredNorm();
    const double left_m2 = std::max(0.0, square_m2 + std::min(0.0, time * offset.dot(velocity_)));
    const double reach_m = a.radius_m + b.radius_m + margin;
    const double needed_m = std::max(margin, reach_m + (time * turning_m - hair_m));
    return reaches_hold_ && square_m2 > reach_m * reach_m &&
           left_m2 * left_m2 >= needed_m * needed_m * square_m2;
  }

 private:
  [[nodiscard]] double margin_m(double time) const {
    constexpr double kMargin = 1e-9;
    return kMargin * (time * fastest_m_ + reach_a_m_ + reach_b_m_);
  }

  Vector3 velocity_{Vector3::Zero()};
  double turn_a_{0.0};
  double turn_b_{0.0};
  double fastest_m_{0.0};  ///< a step, with the turning
  double reach_a_m_{0.0};
  double reach_b_m_{0.0};
  Vector3 centre_a_{Vector3::Zero()};
  Vector3 centre_b_{Vector3::Zero()};
  bool reaches_hold_{false};
};

}  // namespace impetus::inline collision
