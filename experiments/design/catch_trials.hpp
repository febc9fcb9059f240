// Catch trials, spread among the main trials of each block.
//
//   block     | - - - - - - | - - - - - - | - - - - - - |     as many stretches as catch trials
//   with them | - c - - - - - | - - - - c - - | - - - c - - - |   one place drawn in each
//
// The main trials keep their order. A catch trial counts in a longest run like any trial that is
// shown.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/design/trial_order.hpp"

namespace impetus::inline design {

/// Puts the design's catch trials into every block. Their repetition counts those of one kind, in
/// the order shown. False, and nothing done, when no places were found that keep to the longest
/// runs; another order of the main trials may have some.
[[nodiscard]] bool spread_catch_trials(TrialBlocks& blocks, const Design& design,
                                       RandomStream& stream);

}  // namespace impetus::inline design
