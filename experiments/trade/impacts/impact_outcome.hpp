// What the response makes of the contacts of an impact, and how far that is from another answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "experiments/trade/impacts/approach.hpp"

namespace impetus::inline trade {

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
