// Candidate pairs of few bodies, in memory that is used again.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/broad_phase.hpp"

namespace impetus::inline collision {

/// What candidate_pairs(bodies) returns, in place of what `pairs` held.
void find_among_all(const std::vector<MovedBound>& bodies, std::vector<PairBounds>& pairs);

}  // namespace impetus::inline collision
