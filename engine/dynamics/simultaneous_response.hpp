// Collision response by impulses that are found together, island by island.
//
//   repeat     of the contacts that approach now, find the least change of velocity (by energy)
//              after which each separates with at least ε times its approach
//   at last    the least change after which no contact approaches
//
// Only approaching contacts are in a problem, so each round keeps or lowers the energy, whatever
// the restitutions: ΔE = ½ Σ (1 − ε_i) j_i v_i ≤ 0. A wave passes on by one body a round, as in a
// Newton's cradle. (Dingliana 2002, sec. 3.3.1, corrected; Moreau 1988 for the projection)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/impulse.hpp"

namespace impetus::inline dynamics {

/// As respond(), with a restitution in [0, 1] for each contact. An island whose problem cannot be
/// solved gets the impulses of respond() instead.
ResponseResult respond_together(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states);

}  // namespace impetus::inline dynamics
