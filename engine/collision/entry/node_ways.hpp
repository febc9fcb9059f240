// How soon two nodes of bodies on their ways can touch: each node goes its own way.
//
//        u t                  the centre of a node's sphere as it is seen from the other: from
//        where
//   o ─────────►              it is, straight at the velocity that it has now, turning included;
//     `-.  ½ bend T t         it strays from that within a time T by no more than this
//        `.
//
//   |o + u t| = r_a + r_b − hair + ½ bend T t      a quadratic equation: they meet no sooner
//
// What turns goes along an arc, and the bend of an arc grows with the square of the time: where the
// time is short, or the turn small, the way that is foreseen is nearly the way that is gone, and
// most of what passes by is ruled out at once.
//
// within() and apart_for() are to the safe side by a margin far above rounding.
// (cf. the bounds of motion of Redon, Kim, Lin and Manocha 2004; Tang, Kim and Manocha 2009)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/collision/entry/body_path.hpp"
#include "engine/collision/entry/node_gap.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/collision/sphere_block.hpp"

namespace impetus::inline collision {

/// How a node goes against another from now on.
struct NodeWay {
  Vector3 velocity{Vector3::Zero()};  ///< of their spheres' centres, of a against b (metres a step)
  double stray_m{0.0};    ///< from that, at most (metres a step²), of both: half of the bends
  double turning_m{0.0};  ///< of points of the nodes about those centres, at most (metres a step)
  double radii_m{0.0};    ///< of the spheres that bound them, together
};

/// The same of siblings of one body: by sphere.
struct LaneWays {
  LaneValues x;
  LaneValues y;
  LaneValues z;
  LaneValues stray_m;
};

/// Of a block: the velocity of a against b is the row's less the column's.
struct BlockWays {
  LaneWays a;
  LaneWays b;
};

/// Two bodies in a stretch of their ways, and where they are on it.
class NodeWays {
 public:
  using OfPair = NodeWay;
  using OfBlock = BlockWays;

  /// Both ways must outlive it. The bodies' points stay within the reaches of their centres of
  /// mass (metres).
  NodeWays(const BodyPath& path_a, const BodyPath& path_b, double reach_a_m, double reach_b_m)
      : path_a_(path_a), path_b_(path_b), reach_a_m_(reach_a_m), reach_b_m_(reach_b_m) {}

  void enter(const RelativeStretch& stretch);

  /// Where the bodies are at share `time` of the step.
  void place(const Pose& a, const Pose& b, double time);

  /// How far it is worth looking ahead, of what is left: so far that no body turns by more than
  /// about half a radian, in equal parts.
  [[nodiscard]] double horizon(double left) const;

  [[nodiscard]] NodeWay of(const Sphere& a, const Sphere& b) const;

  /// Of the spheres of a row and a column of a block.
  [[nodiscard]] static NodeWay of(const BlockWays& ways, const SphereBlock& block, int row,
                                  int column);

  /// For how long two nodes stay apart that may come nearer by `way_m` than the gap at which they
  /// are now says: at least, if that is less than `most`; else at least `most`. Of spheres.
  [[nodiscard]] static double time_of_spheres(double way_m, const NodeGap& now, const NodeWay& way,
                                              double most);

  /// Of any nodes: nothing comes nearer than by their points' speed along the normal.
  [[nodiscard]] static double time_of_nodes(double way_m, const NodeGap& now, const NodeWay& way,
                                            double most);

  /// The pairs of a block that could touch by more than `hair_m` within `time`: of the others
  /// apart_for() is true. Finds the ways of its spheres.
  [[nodiscard]] std::uint64_t within(double time, double hair_m, const SphereBlock& block,
                                     BlockWays& ways, LaneWidth width = widest_lanes()) const;

  /// Whether two spheres cannot. With the offset o, A = o², B = o·u, C = u² and the reach
  ///   R = r_a + r_b − hair + margin + stray · time²
  /// they are furthest from touching where they go apart (B ≥ 0), at the end of the time if they
  /// still come nearer there (B + time C ≤ 0), else where they pass: A − B²/C.
  [[nodiscard]] bool apart_for(double time, double hair_m, const Sphere& a, const Sphere& b,
                               const NodeWay& way) const;

 private:
  const BodyPath& path_a_;
  const BodyPath& path_b_;
  double reach_a_m_;
  double reach_b_m_;
  RelativeStretch stretch_;
  double margin_m_{0.0};
  Pose pose_a_;
  Pose pose_b_;
  Vector3 spin_a_{Vector3::Zero()};  ///< radians a step
  Vector3 spin_b_{Vector3::Zero()};
  bool reaches_hold_{false};
};

}  // namespace impetus::inline collision
