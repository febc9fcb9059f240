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

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline dynamics {

/// How the impulses of contacts that affect each other are found: one after the other, or for all
/// of an island together, after which nothing approaches (see impulses_together.hpp).
enum class ResponseMethod { kInTurn, kTogether };

inline constexpr int kUnlimitedPasses = std::numeric_limits<int>::max();

/// The work of a response that can be interrupted.
//
//   passes     over all contacts, as without a meter, until they are refused
//   visible    of those that may approach still, always the most visible, until that is refused too
//   walls      a few passes over the contacts with walls, in any case
//
// Each push keeps or lowers the energy, so it can end anywhere. What approaches then is met in the
// next step.
struct ResponseWork {
  PhaseWork passes;
  PhaseWork visible;
  /// The indices of the contacts, the most visible first: asked for when passes are refused.
  std::function<std::span<const std::size_t>()> most_visible_first;
};

/// As it stands: until nothing approaches, at most two passes for each contact.
struct ResponseRules {
  ResponseMethod method{ResponseMethod::kInTurn};
  /// Where this many passes over the contacts of an island, 1 or more, are fewer than two for each
  /// contact, they are all there is: no pass without restitution follows, and what still approaches
  /// is left to the next step. What the response costs is then at most this often its contacts.
  int most_passes{kUnlimitedPasses};
  /// Of an approach slower than this (m/s) nothing is given back.
  double resting_m_s{0.0};
  /// What the hinges of figures must leave of how a contact's bodies would give way alone, for it
  /// to be pushed: of what they hold rounding is left, and a push divided by that is of any size.
  double least_share_of_give{1e-10};
  ResponseWork* work{nullptr};  ///< none: nothing interrupts it
};

/// Velocity of a's point at the contact relative to b's, along the normal (m/s): negative when
/// they approach. Arms run from the centres of mass. (eq. 3.2 and 3.3, corrected)
double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states);

/// Share of the largest incoming speed below which an approach is rounding.
inline constexpr double kNegligibleApproach = 1e-9;

/// What the response did.
struct ResponseResult {
  std::vector<double> impulse_Ns;     ///< per contact, along its normal, ≥ 0
  std::vector<double> approach_m_s;   ///< per contact before the response; 0 when separating
  double fastest_m_s{0.0};            ///< largest speed that any contact's bodies brought to it
  double residual_approach_m_s{0.0};  ///< largest approach that the passes left; 0 if negligible
};

/// The direction of the impulses' sum, unit, and their mean place, of no depth; of impulses that
/// are all zero, the deepest contact. `impulse_Ns` (along each contact's normal) is as long as
/// `contacts`, which must not be empty.
TouchPoint net_contact(const std::vector<Contact>& contacts, const std::vector<double>& impulse_Ns);

}  // namespace impetus::inline dynamics
