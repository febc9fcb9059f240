// The order of main trials: drawn, block by block, until the longest runs are kept to.
//
// Shuffling until the rules hold draws every permitted order with the same probability, which
// repairing a bad order would not. Rules that almost no order keeps to are met trial by trial
// instead: each is drawn from those that leave the rest possible. Every permitted order can then
// come, though not all are equally likely.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "experiments/design/plan.hpp"

namespace impetus::inline design {

/// The trials of each block, blocks in the order shown.
using TrialBlocks = std::vector<std::vector<PlannedTrial>>;

/// Whether no run is longer than the rules allow, from the first block through to the last.
/// Every condition has a level of each rule's factor.
bool keeps_to(const TrialBlocks& blocks, const std::vector<LongestRun>& rules);

/// Orders the trials within each block. Throws std::runtime_error when no permitted order was
/// found.
void draw_order(TrialBlocks& blocks, const std::vector<LongestRun>& rules, RandomStream& stream);

}  // namespace impetus::inline design
