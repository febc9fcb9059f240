// SPDX-License-Identifier: MIT
#include "engine/collision/list_refinement.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace impetus {
namespace {

/// The pairs of one list that still wait for work: [next, end).
struct Queue {
  std::size_t next{0};
  std::size_t end{0};

  [[nodiscard]] bool empty() const { return next == end; }
};

/// Brings every pair to its list's least level; returns the tests it took, roots included.
std::int64_t do_floor(std::vector<RefinedPair>& pairs, const std::vector<PriorityList>& lists) {
  auto tests = static_cast<std::int64_t>(pairs.size());
  for (RefinedPair& pair : pairs) {
    const int least_level = lists[static_cast<std::size_t>(pair.list)].least_level;
    while (pair.refinement.level() < least_level && !pair.refinement.resolved()) {
      tests += pair.refinement.next_block();
      pair.refinement.refine_one_block();
    }
  }
  return tests;
}

std::array<Queue, kMostLists> queues_of(const std::vector<RefinedPair>& pairs) {
  std::array<Queue, kMostLists> queues{};
  std::size_t next = 0;
  for (std::size_t list = 0; list < kMostLists; ++list) {
    queues[list].next = next;
    while (next < pairs.size() && pairs[next].list == static_cast<int>(list)) {
      ++next;
    }
    queues[list].end = next;
  }
  return queues;
}

/// The list that gets the next block.
class Shares {
 public:
  explicit Shares(const std::vector<PriorityList>& lists) : lists_(&lists) {
    for (const PriorityList& list : lists) {
      sum_ += list.share;
    }
  }

  /// Precondition: some queue is not empty.
  [[nodiscard]] std::size_t next_list(const std::array<Queue, kMostLists>& queues,
                                      const WorkDone& done) const {
    const std::size_t count = lists_->size();
    if (count == 1) {
      return 0;
    }
    const std::array<double, kMostLists> behind = behind_of(queues, done);
    std::size_t best = count;
    for (std::size_t list = 0; list < count; ++list) {
      if (!queues[list].empty() && (best == count || goes_before(list, best, behind))) {
        best = list;
      }
    }
    return best;
  }

 private:
  [[nodiscard]] bool goes_before(std::size_t list, std::size_t other,
                                 const std::array<double, kMostLists>& behind) const {
    return behind[list] > behind[other] ||
           (behind[list] == behind[other] && (*lists_)[list].share > (*lists_)[other].share);
  }

  /// Tests that each list is owed: its share of what was spent, and what finished lists left.
  [[nodiscard]] std::array<double, kMostLists> behind_of(
      const std::array<Queue, kMostLists>& queues, const WorkDone& done) const {
    const std::size_t count = lists_->size();
    const auto refined = static_cast<double>(done.spent - done.floor);
    std::array<double, kMostLists> behind{};
    for (std::size_t list = 0; list < count; ++list) {
      const double owed =
          (*lists_)[list].share / sum_ * refined - static_cast<double>(done.by_list[list]);
      std::size_t heir = list;
      while (queues[heir].empty()) {
        heir = (heir + 1) % count;
      }
      behind[heir] += owed;
    }
    return behind;
  }

  const std::vector<PriorityList>* lists_;
  double sum_{0.0};
};

}  // namespace

WorkDone refine_by_lists(std::vector<RefinedPair>& pairs, const std::vector<PriorityList>& lists,
                         WorkMeter& meter, std::int64_t work_before) {
  WorkDone done;
  done.floor = work_before + do_floor(pairs, lists);
  done.spent = done.floor;
  done.granted = meter.request(done.spent);
  if (lists.size() > 1) {
    done.by_list.assign(lists.size(), 0);
  }
  if (pairs.empty()) {
    return done;
  }
  std::array<Queue, kMostLists> queues = queues_of(pairs);
  const Shares shares(lists);
  std::size_t waiting = pairs.size();
  while (waiting > 0) {
    const std::size_t list = shares.next_list(queues, done);
    PairRefinement& refinement = pairs[queues[list].next].refinement;
    bool finished = refinement.resolved();
    if (!finished) {
      const std::int64_t block = refinement.next_block();
      done.granted = std::max(done.granted, meter.request(done.spent + block));
      finished = done.granted < done.spent + block;
      if (!finished) {
        refinement.refine_one_block();
        done.spent += block;
        if (!done.by_list.empty()) {
          done.by_list[list] += block;
        }
      }
    }
    if (finished) {
      ++queues[list].next;
      --waiting;
    }
  }
  return done;
}

}  // namespace impetus
