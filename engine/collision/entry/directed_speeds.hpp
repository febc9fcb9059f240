// How soon two nodes can touch, by the rules of recording formats below 8: by how fast their points
// can come towards each other along the gap, in whatever direction they turn.
//
//   |<-- gap -->|         a and b approach by no more than speed · time + turning · time: what is
//  (a)         (b)        further apart does not touch
//
// within() and apart_for() are to the safe side by a margin far above rounding: what they rule out,
// time_of_nodes() rules out too. So a search that leaves it out finds the same.
// (Zhang et al. 2006)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "engine/collision/entry/body_path.hpp"
#include "engine/collision/entry/node_gap.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/collision/sphere_block.hpp"

namespace impetus::inline collision {

/// How fast points of a block's spheres can move by their body's turning (metres a step).
struct BlockTurning {
  LaneValues a;  ///< by row
  LaneValues b;  ///< by column
};

/// Two bodies in a stretch of their ways, and where they are on it; used as NodeWays.
class DirectedSpeeds {
 public:
  using OfPair = double;  ///< how fast points can move towards each other by turning
  using OfBlock = BlockTurning;

  DirectedSpeeds(const BodyPath& /*path_a*/, const BodyPath& /*path_b*/, double reach_a_m,
                 double reach_b_m)
      : reach_a_m_(reach_a_m), reach_b_m_(reach_b_m) {}

  void enter(const RelativeStretch& stretch);

  /// Nothing is ruled out if the poses are not such that the reaches hold: they are numbers, turn
  /// without stretching and are not so far off that rounding counts.
  void place(const Pose& a, const Pose& b, double time);

  [[nodiscard]] static double horizon(double left) { return left; }

  [[nodiscard]] double of(const Sphere& a, const Sphere& b) const {
    double speed_m = 0.0;
    if (turn_a_ > 0.0) {
      speed_m += turn_a_ * ((a.centre - centre_a_).norm() + a.radius_m);
    }
    if (turn_b_ > 0.0) {
      speed_m += turn_b_ * ((b.centre - centre_b_).norm() + b.radius_m);
    }
    return speed_m;
  }

  [[nodiscard]] static double of(const BlockTurning& turning, const SphereBlock& /*block*/, int row,
                                 int column) {
    return turning.a[lane(row)] + turning.b[lane(column)];
  }

  [[nodiscard]] double time_of_nodes(double way_m, const NodeGap& now, double turning_m,
                                     double /*most*/) const {
    const double closing_m = std::max(0.0, -now.normal.dot(velocity_)) + turning_m;
    return closing_m > 0.0 ? way_m / closing_m : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] double time_of_spheres(double way_m, const NodeGap& now, double turning_m,
                                       double most) const {
    return time_of_nodes(way_m, now, turning_m, most);
  }

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
