// Which blocks a participant's main trials come in, and in which order.
//
//   factors {level}, levels 0 2 6, order latin-square       P01  0 2 6     P04  2 0 6
//                                                            P02  2 6 0     ...
//
// A Williams square of n conditions has n rows for even n, 2n for odd n. Each condition comes
// equally often in each place, and each follows each other one equally often (Williams 1949).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/design/trial_order.hpp"

namespace impetus::inline design {

/// The rows of a Williams square: orders of the conditions 0 to `count` − 1. `count` ≥ 1.
std::vector<std::vector<std::size_t>> williams_square(std::size_t count);

/// The combinations of the block factors' levels in the order in which this participant gets
/// their blocks; an empty condition for each block of a design whose blocks are alike, and one for
/// a design without blocks. Throws InputError, naming
/// --participant, when a Latin square meets a code that does not end in a number.
std::vector<Condition> block_order(const Design& design, const PlanKey& key);

/// `trials` divided among the design's blocks, in the participant's order of them, with the number
/// of each trial's block. Blocks alike get equally many repetitions, the first block the first
/// ones; their count divides the repetitions (or a track's trials).
TrialBlocks divided(std::vector<PlannedTrial> trials, const Design& design, const PlanKey& key);

}  // namespace impetus::inline design
