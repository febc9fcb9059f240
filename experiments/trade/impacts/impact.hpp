// One impact of two bodies: how they come to touch, what the response makes of it, and how far that
// is from another answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"

namespace impetus::inline trade {

/// Two bodies that have just touched, and what is exactly true of it.
struct ExactImpact {
  std::vector<BodyState> states;  ///< of a and b, before the response
  TouchPoint touch;               ///< normal from b to a
  double approach_m_s{0.0};       ///< along the normal, spins included; more than 0
};

/// Random approaches of two bodies, and the exact impact where they touch.
///
///   a random line, random turns ──> straight and unturned ──> first touch of the surfaces, or past
///   the closest points just before ──> exact normal and point; speeds and spins of the scene's own
///
/// Lines are uniform: of any direction, through any place at which the balls about the bodies meet.
/// Spins count at the impact alone. Then a is moved on by so little that the surfaces cross: bounds
/// that cover them must overlap.
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

/// Of both bodies after an impact, in world.
struct ImpactOutcome {
  /// Direction of the impulses' sum and their mean place; the deepest contact when none pushes.
  TouchPoint net;
  std::array<Vector3, 2> velocity_m_s;
  std::array<Vector3, 2> spin_rad_s;
};

/// Precondition: there are contacts, between bodies 0 and 1, which are the pair's a and b.
ImpactOutcome outcome_of(const std::vector<Contact>& contacts, const ExactImpact& impact,
                         const ImpactPair& pair, Responder& responder);

/// How far an outcome is from another.
struct ImpactErrors {
  double normal_deg{0.0};
  double point{0.0};  ///< share of ImpactPair::size_m()
  /// Of the velocities of the centres of mass, sqrt(Σ |Δv|²), and of the bodies' surfaces by their
  /// spins, sqrt(Σ (r |Δω|)²) with r the radius about the centre of mass: as shares of the speed at
  /// which the points that touch approached. A share stays finite where what it is of is small.
  double linear{0.0};
  double angular{0.0};
};

ImpactErrors errors_of(const ImpactOutcome& found, const ImpactOutcome& reference,
                       const ExactImpact& impact, const ImpactPair& pair);

}  // namespace impetus::inline trade
