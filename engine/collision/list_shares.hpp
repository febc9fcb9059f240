// Which priority list gets the next block of work: the one furthest behind its share.
//
// What a finished list leaves of its share flows on to the next list in order.
// (Dingliana 2002, sec. 5.1.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/scheduling/priority_lists.hpp"

namespace impetus::inline collision {

class ListShares {
 public:
  /// `lists` must outlive this.
  explicit ListShares(const std::vector<PriorityList>& lists);

  /// `waits` says of each list whether any of its pairs waits for work, `work` how much it has got;
  /// `work` may be empty when there is one list. Precondition: some list waits.
  [[nodiscard]] std::size_t next_list(const std::array<bool, kMostLists>& waits,
                                      const std::vector<std::int64_t>& work) const;

 private:
  [[nodiscard]] bool goes_before(std::size_t list, std::size_t other,
                                 const std::array<double, kMostLists>& behind) const;
  [[nodiscard]] std::array<double, kMostLists> behind_of(
      const std::array<bool, kMostLists>& waits, const std::vector<std::int64_t>& work) const;

  const std::vector<PriorityList>* lists_;
  double sum_{0.0};
};

}  // namespace impetus::inline collision
