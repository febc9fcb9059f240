// Collision response by impulses that never add energy.
//
//   repeat, at most `passes` times:  for each contact that approaches, in order,
//        j = −(1 + ε) v / (n·A n),  P_a += j n,  P_b −= j n,  L_i ± r_i × j n
//   then once more with ε = 0
//
// Each impulse alone keeps or lowers the energy (ε in [0, 1]), so any number of them does.
// (Dingliana 2002, eq. 3.1–3.6, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"

namespace impetus {

/// Velocity of a's point at the contact relative to b's, along the normal (m/s): negative when
/// they approach. Arms run from the centres of mass. (eq. 3.2 and 3.3, corrected)
double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states);

/// Share of the largest incoming speed below which an approach is rounding.
inline constexpr double kNegligibleApproach = 1e-9;

struct ResponseResult {
  std::vector<double> impulse_Ns;     ///< per contact, along its normal, ≥ 0
  std::vector<double> approach_m_s;   ///< per contact before the response; 0 when separating
  double residual_approach_m_s{0.0};  ///< largest approach that the passes left; 0 if negligible
};

/// Applies impulses to `states` until no contact approaches or the passes (two per contact) are
/// used up; what is left is reported. `restitution` in [0, 1].
ResponseResult respond(const std::vector<Contact>& contacts, double restitution,
                       const std::vector<BodyModel>& models, std::vector<BodyState>& states);

}  // namespace impetus
