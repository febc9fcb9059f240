// SPDX-License-Identifier: MIT
#include "engine/collision/work_ledger.hpp"

#include <algorithm>

namespace impetus::inline collision {

WorkLedger::Demand WorkLedger::for_next_block(const RefinedPair& pair, std::size_t index) const {
  const PairRefinement& refinement = pair.refinement;
  const std::int64_t most_nodes =
      std::max(static_cast<std::int64_t>(refinement.overlapping().size()),
               refinement.most_found_after_next_block());
  const std::int64_t reserved =
      reserved_ - reserves_[index] + costs_.of_later_phases(pair, most_nodes);
  return {spent_ + costs_.of_tests(pair, refinement.next_block()) + reserved, reserved};
}

void WorkLedger::note(const RefinedPair& pair, std::size_t index, std::int64_t tests) {
  const PairRefinement& refinement = pair.refinement;
  const std::int64_t nodes = std::max(static_cast<std::int64_t>(refinement.overlapping().size()),
                                      refinement.found_so_far());
  spent_ += costs_.of_tests(pair, tests);
  reserved_ -= reserves_[index];
  reserves_[index] = costs_.of_later_phases(pair, nodes);
  reserved_ += reserves_[index];
}

}  // namespace impetus::inline collision
