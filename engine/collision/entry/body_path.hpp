// The way of a body within a step: at rest, then straight and by the shortest turn, then at rest.
//
//   0 ------- begin ~~~~~~~~~~~~~~~~ stop ------- 1      shares of the step
//     start           moving              end
//
// This is the way that is drawn. The turn is interpolated by normalised quaternions, which turn
// fastest half way: by 4 tan(Θ/4) a stretch for a turn by Θ. At share s of the stretch they turn by
// 2 sin(Θ/2) / (1 − 2 s (1 − s) (1 − cos(Θ/2))), and that changes by at most 16 tan³(Θ/4).
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/few.hpp"
#include "engine/numerics/vector.hpp"

namespace impetus::inline collision {

/// Where a body begins and ends its way, and between which shares of the step it moves.
struct BodyPath {
  Pose start;
  Pose end;
  double begin{0.0};
  double stop{1.0};
};

/// Where the body is at share `time` of the step.
Pose pose_at(const BodyPath& path, double time);

/// How it turns at share `time` of the step, while it moves: about this axis, at this speed
/// (radians a step).
Vector3 turning_at(const BodyPath& path, double time);

/// A length whose fourth power is an ordinary number.
inline bool can_be_squared(double length_m) { return length_m > 1e-60 && length_m < 1e50; }

/// Whether points that stay within the reach of the centre of mass do so in the world, too: the
/// pose is of numbers, turns without stretching and is not so far off that rounding counts.
bool reach_holds(const Pose& pose, double reach_m);

/// At most how far a point no further than `reach_m` from the centre of mass goes (metres).
double farthest_m(const BodyPath& path, double reach_m);

/// How two bodies move against each other from share `begin` of the step to `end`: nothing of it
/// changes in between.
struct RelativeStretch {
  double begin{0.0};
  double end{0.0};
  Vector3 velocity{Vector3::Zero()};  ///< of a against b (metres a step)
  double turn_a{0.0};                 ///< at most (radians a step)
  double turn_b{0.0};
  /// How far that is from straight and steady: at most the second derivative of where a point is
  /// that lies a metre from the centre of mass (metres a step², for each metre).
  double bend_a{0.0};
  double bend_b{0.0};

  /// At most how far points of the bodies come towards each other (metres a step): those no
  /// further than `reach_a_m` and `reach_b_m` from the centres of mass.
  [[nodiscard]] double fastest(double reach_a_m, double reach_b_m) const {
    return velocity.norm() + turn_a * reach_a_m + turn_b * reach_b_m;
  }
};

/// In order of time: ways with two ends each have three at most.
using Stretches = Few<RelativeStretch, 3>;

/// The stretches in which one body or both move.
Stretches stretches_of(const BodyPath& a, const BodyPath& b);

/// At most how far points so far from the centres of mass move against each other from share `from`
/// of the step on (metres).
double way_from(double from, const Stretches& stretches, double reach_a_m, double reach_b_m);

}  // namespace impetus::inline collision
