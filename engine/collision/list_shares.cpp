// SPDX-License-Identifier: MIT
#include "engine/collision/list_shares.hpp"

#include <numeric>

namespace impetus::inline collision {

ListShares::ListShares(const std::vector<PriorityList>& lists) : lists_(&lists) {
  for (const PriorityList& list : lists) {
    sum_ += list.share;
  }
}

std::size_t ListShares::next_list(const std::array<bool, kMostLists>& waits,
                                  const std::vector<std::int64_t>& work) const {
  const std::size_t count = lists_->size();
  if (count == 1) {
    return 0;
  }
  const std::array<double, kMostLists> behind = behind_of(waits, work);
  std::size_t best = count;
  for (std::size_t list = 0; list < count; ++list) {
    if (waits[list] && (best == count || goes_before(list, best, behind))) {
      best = list;
    }
  }
  return best;
}

bool ListShares::goes_before(std::size_t list, std::size_t other,
                             const std::array<double, kMostLists>& behind) const {
  return behind[list] > behind[other] ||
         (behind[list] == behind[other] && (*lists_)[list].share > (*lists_)[other].share);
}

/// Units that each list is owed: its share of what was spent, and what finished lists left.
std::array<double, kMostLists> ListShares::behind_of(const std::array<bool, kMostLists>& waits,
                                                     const std::vector<std::int64_t>& work) const {
  const std::size_t count = lists_->size();
  const auto in_all =
      static_cast<double>(std::accumulate(work.begin(), work.end(), std::int64_t{0}));
  std::array<double, kMostLists> behind{};
  for (std::size_t list = 0; list < count; ++list) {
    const double owed = (*lists_)[list].share / sum_ * in_all - static_cast<double>(work[list]);
    std::size_t heir = list;
    while (!waits[heir]) {
      heir = (heir + 1) % count;
    }
    behind[heir] += owed;
  }
  return behind;
}

}  // namespace impetus::inline collision
