// Free motion: momenta are constant, so the position is exact and only the rotation is integrated.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dynamics/body.hpp"

namespace impetus {

/// How a body's rotation is stepped. Both leave the angular momentum L untouched, and turn by the
/// Cayley map of one angular velocity for the step, found by a fixed number of iterations.
enum class Rotation {
  /// ω of the orientation half way between the old and the new: the energy swings about its value,
  /// for the .2 × .4 × .6 m box at 5 rad/s by 7e-5 with steps of 10 ms. Four iterations.
  kMidpoint,
  /// I⁻¹ of the mean of L as seen from the body before and after: the energy is kept to rounding
  /// where the iterations converge, below a turn of half a radian a step. Sixteen iterations.
  /// (Simo and Wong 1991)
  kEnergyKept,
};

/// Moves a body through `dt_s` seconds, less what an imposed hold still takes from it; uses no
/// trigonometry. A body without spin skips the rotation. Returns the distance its centre moved
/// (metres).
double advance(const BodyModel& model, BodyState& state, double dt_s,
               Rotation rotation = Rotation::kMidpoint);

/// The pose at `fraction` of the step from `before` to `after`, for drawing alone.
Pose between(const BodyState& before, const BodyState& after, double fraction);

}  // namespace impetus
