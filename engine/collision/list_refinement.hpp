// Refining all pairs of a step within its budget, each priority list by its share.
//
//   floor     level 0 of every pair and its list's least level, whatever the budget
//   rounds    the list furthest behind its share: its first pair, one block of node-pair tests
//
// What a finished list leaves of its share flows on to the next list in order. The order of blocks
// does not depend on the budget, so cutting it anywhere leaves each list its share, and the total
// granted is all that a replay needs. (Dingliana 2002, sec. 5.1.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/collision/pair_refinement.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus {

struct RefinedPair {
  BodyPair bodies;
  int list{0};
  PairRefinement refinement;
};

/// In node-pair tests.
struct WorkDone {
  std::int64_t granted{0};
  std::int64_t spent{0};
  std::int64_t floor{0};              ///< part of `spent` that no budget could prevent
  std::vector<std::int64_t> by_list;  ///< beyond the floor; empty when there is one list
};

/// Refines `pairs`, which come by list and by falling priority within each, until all are resolved
/// or `meter` refuses. `work_before` was done already and is part of the floor. A pair whose next
/// block is refused gives way to the next of its list.
WorkDone refine_by_lists(std::vector<RefinedPair>& pairs, const std::vector<PriorityList>& lists,
                         WorkMeter& meter, std::int64_t work_before = 0);

}  // namespace impetus
