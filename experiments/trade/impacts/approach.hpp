// Random approaches of two bodies, and the exact impact where they touch.
//
//   a random line, random turns ──> straight and unturned ──> first touch of the surfaces, or past
//   the closest points just before ──> exact normal and point; speeds and spins of the scene's own
//
// Lines are uniform: of any direction, through any place at which the balls about the bodies meet.
// Spins count at the impact alone. Then a is moved on by so little that the surfaces cross: bounds
// that cover them must overlap.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "engine/numerics/random_stream.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"

namespace impetus::inline trade {

/// Two bodies that have just touched, and what is exactly true of it.
struct ExactImpact {
  std::vector<BodyState> states;  ///< of a and b, before the response
  TouchPoint touch;               ///< normal from b to a
  double approach_m_s{0.0};       ///< along the normal, spins included; more than 0
};

struct Approach {
  Pose pose_a;  ///< where a starts: far from b
  Pose pose_b;
  Vector3 direction{Vector3::UnitX()};  ///< unit, of a
  bool touches{false};                  ///< the surfaces meet on the way
  /// None when they do not, or only graze: when they approach each other, as the centres do and as
  /// the points that touch do, at less than a fifth of the centres' speed.
  std::optional<ExactImpact> impact{};
};

/// The next approach of the stream.
Approach next_approach(RandomStream& random, const ImpactPair& pair);

}  // namespace impetus::inline trade
