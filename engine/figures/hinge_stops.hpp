// Where hinges must not turn further: at their limits, and where neighbours are folded together.
//
// Each is a contact that turns: an angular impulse of the child against the parent, never pulling,
// found among the impulses of all other contacts.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/figures/figure.hpp"

namespace impetus::inline figures {

/// A limit within reach of the next step.
struct HingeStop {
  std::size_t figure{0};
  std::size_t hinge{0};
  Vector3 axis{Vector3::UnitZ()};  ///< world, unit: away from the limit the child turns about it
  double allowed_rad_s{0.0};       ///< at which it would arrive within a step; 0 at the limit
};

/// Adds the stops of a free figure's hinges that are nearer than kStopReach to a limit.
inline constexpr double kStopReach = 0.25;  ///< radians
void add_stops(std::span<const Figure> figures, std::size_t figure,
               const std::vector<BodyState>& states, double dt_s, std::vector<HingeStop>& stops);

/// The axis about which the child turns, against the parent, when the two open (world, unit).
Vector3 opening_axis(const Hinge& hinge, const Pose& child, const Pose& parent);

/// The hinge that joins the two parts; none: null.
const Hinge* hinge_between(const Figure& figure, BodyPair parts);

/// A contact for each pair of neighbours that are folded past their threshold: at the hinge, from
/// the second's centre of mass towards the first's, as deep as the tips of their cores are beyond
/// the threshold. `rest_openings` are opening_at_rest() of the hinges.
void add_folds(const Figure& figure, std::span<const double> rest_openings,
               const std::vector<BodyState>& states, std::vector<Contact>& folds);

}  // namespace impetus::inline figures
