// Catch trials, spread among the main trials of each block.
//
//   block     | - - - - - - | - - - - - - | - - - - - - |     as many stretches as catch trials
//   with them | - c - - - - - | - - - - c - - | - - - c - - - |   one place drawn in each
//
// The main trials keep the order they were drawn in. A catch trial counts in a longest run like
// any trial that is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/trial_order.hpp"

namespace impetus {

/// Puts the design's catch trials into every block. Their repetition counts those of one kind, in
/// the order shown. Throws std::runtime_error when no places were found that keep to the longest
/// runs.
void spread_catch_trials(TrialBlocks& blocks, const Design& design, RandomStream& stream);

}  // namespace impetus
