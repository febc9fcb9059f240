// Free motion: the angular momentum is constant and the linear one grows by gravity alone, so the
// position is exact, on a parabola, and only the rotation is integrated.
//
// A body that was pushed upwards when the step before ended does not fall in the step: it goes
// where its velocity takes it, and what gravity adds to its momentum is for the contact to take
// away. Nor does it go down while it is slower than gravity makes it in kRestingSteps steps: what
// lies still stays where it is, though impulses in turn leave it a little of that speed. In such a
// step it gains (kRestingSteps + ½) m g² dt² at the most. One that its velocity lifts faster than
// gravity pulls it down is on its parabola as well, so a ball that bounces keeps its energy.
//
// Where a body turns far in a step, or its moments of inertia are far apart, iterations do not
// converge. There the energy is split:
//
//   ½ Π·I⁻¹Π  =  ½ w_j |Π|²  +  ½ (w_k − w_j) Π_k²  +  ½ (w_i − w_j) Π_i²
//                about L        about axis k           about axis i
//
// Π is L as the body sees it, w the inverse principal moments.
// Each part alone is a steady turn about a fixed axis, known exactly. The first goes with both
// others; those two are taken in turn, half of one before and half after, in as many parts of the
// step as keep their error small: the axis k is the one whose two others are most alike, so for a
// needle, a plate or a ball a step is one part. At last Π moves on its sphere to the energy that it
// had. The angular momentum is untouched, and the energy kept to rounding. (Touma and Wisdom 1994)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dynamics/body.hpp"
#include "engine/dynamics/midpoint_rotation.hpp"

namespace impetus::inline dynamics {

/// How a body's rotation is stepped. Both leave the angular momentum L untouched, and turn by the
/// Cayley map of one angular velocity for the step, found by a fixed number of iterations; where
/// these could not converge, both turn as turned_far() does.
enum class Rotation {
  /// ω of the orientation half way between the old and the new: the energy swings about its value,
  /// for the .2 × .4 × .6 m box at 5 rad/s by 7e-5 with steps of 10 ms. Four iterations.
  kMidpoint,
  /// I⁻¹ of the mean of L as seen from the body before and after: the energy is kept to rounding
  /// where the iterations converge, below a turn of half a radian a step. Sixteen iterations.
  /// (Simo and Wong 1991)
  kEnergyKept,
};

/// Below what gravity makes of a body in so many steps, it rests on what it touches.
inline constexpr double kRestingSteps = 2.0;

/// What gravity does to a body in a step; without gravity, nothing.
struct Fall {
  Vector3 gravity_m_s2{Vector3::Zero()};
  bool supported{false};  ///< its momentum falls, its place goes with its velocity alone
  bool resting{false};    ///< and not down
  /// Where a step is made in parts, its momentum falls in the last: else the others would carry it
  /// down.
  bool comes_last{false};
};

/// How a body falls in a step of `dt_s` seconds. `pushed_up`: when the step before ended.
Fall fall_of(const BodyModel& model, const BodyState& state, bool pushed_up,
             const Vector3& gravity_m_s2, double dt_s);

/// Moves a body through `dt_s` seconds, less what an imposed hold still takes from it: then its
/// time stands still and it does not fall. Uses no trigonometry. A body without spin skips the
/// rotation. Returns the distance from where its centre was to where it is (metres): within a step
/// a body is taken to go straight, which its parabola leaves by at most g dt²/8.
double advance(const BodyModel& model, BodyState& state, double dt_s,
               Rotation rotation = Rotation::kMidpoint, const Fall& fall = {});

/// Moves many bodies as advance() moves each, to the bit, and sooner.
class AdvancingBodies {
 public:
  /// A body's centre is where it goes to; its orientation, at finish() at the latest. The state
  /// must stay where it is until then. Returns what advance() does.
  double take(const BodyModel& model, BodyState& state, double dt_s, Rotation rotation,
              const Fall& fall);

  void finish() { turning_.turn(); }

 private:
  TurningBodies turning_;
};

/// The pose at `fraction` of the step from `before` to `after`, for drawing alone.
Pose between(const BodyState& before, const BodyState& after, double fraction);

/// Of a step, at most: a turn beyond what these take well is taken less well, but keeps energy.
inline constexpr int kMostTurnParts = 4096;

/// Whether motion.hpp's iterations could fail to converge: by how far L can turn within the body. A
/// ball, within which it does not turn, never turns far.
bool turns_far(const BodyModel& model, const BodyState& state, double dt_s);

/// The orientation after `dt_s` seconds.
Quaternion turned_far(const BodyModel& model, const BodyState& state, double dt_s);

}  // namespace impetus::inline dynamics
