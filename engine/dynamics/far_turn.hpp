// The rotation of a free body that turns far in a step, or whose moments of inertia are far apart:
// there the iterations of motion.hpp do not converge.
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

namespace impetus::inline dynamics {

/// Of a step, at most: a turn beyond what these take well is taken less well, but keeps energy.
inline constexpr int kMostTurnParts = 4096;

/// Whether motion.hpp's iterations could fail to converge: by how far L can turn within the body. A
/// ball, within which it does not turn, never turns far.
bool turns_far(const BodyModel& model, const BodyState& state, double dt_s);

/// The orientation after `dt_s` seconds.
Quaternion turned_far(const BodyModel& model, const BodyState& state, double dt_s);

}  // namespace impetus::inline dynamics
