// Sharing a step's work: all its pairs are refined within its budget, each list by its share.
//
//   floor     level 0 of every pair and its list's least level, whatever the budget
//   rounds    the list furthest behind its share (ListShares): its most urgent pair by the
//             traversal (WaitingPairs), one block of node-pair tests
//
// A block starts only when its tests, and what modelling and response could cost after it, are
// granted (work_ledger.hpp), so always spent + reserved ≤ max(granted, floor). The order of blocks
// does not depend on the budget until it refuses one, so cutting it anywhere leaves each list its
// share, and the total granted is all that a replay needs.
// (Dingliana 2002, sec. 5.1.2; eq. 3.9, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/collision/work_ledger.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline collision {

/// In units of work.
struct WorkDone {
  std::int64_t granted{0};
  std::int64_t spent{0};              ///< on tests
  std::int64_t floor{0};              ///< what no budget could prevent, later phases included
  std::vector<std::int64_t> by_list;  ///< on tests beyond the floor; empty when there is one list
  std::int64_t reserved{0};           ///< for the later phases, when refinement ended
  std::int64_t peak{0};               ///< the most that was spent and reserved at any time
  WorkGrants grants{};                ///< of WorkPhase::kTests, where they were refused
};

/// What the work is counted by, and in which order each list's pairs get it.
struct RefinementSettings {
  std::shared_ptr<const Traversal> traversal = make_traversal("depth-first");
  WorkCosts costs{};
  ContactModel contacts{};      ///< what modelling and response will get
  std::int64_t work_before{0};  ///< done already in this step, part of the floor
};

/// How soon a pair comes by the traversal, larger sooner.
double urgency(const RefinedPair& pair, const Traversal& traversal, const PhaseCosts& costs);

/// The pairs of one priority list that wait for work, and which of them is next: the most urgent,
/// of equally urgent ones that of the highest rank. A pair's urgency changes only when a level of
/// it is complete, so one that was begun is finished first.
class WaitingPairs {
 public:
  void clear() {
    waiting_.clear();
    first_ = 0;
    is_queue_ = true;
  }
  [[nodiscard]] bool empty() const { return first_ == waiting_.size(); }

  /// `index` is the pair's rank by priority.
  void add(std::size_t index, double urgency);

  /// Precondition: !empty().
  [[nodiscard]] std::size_t next() const { return waiting_[first_].index; }
  void remove_next();

  /// Whether `is_one` holds for the index of any.
  template <typename IsOne>
  [[nodiscard]] bool any(const IsOne& is_one) const {
    return std::any_of(waiting_.begin() + static_cast<std::ptrdiff_t>(first_), waiting_.end(),
                       [&](const Waiting& waiting) { return is_one(waiting.index); });
  }

 private:
  /// A pair by its rank, and how urgent its next block of work is.
  struct Waiting {
    double urgency;
    std::size_t index;
  };
  static bool comes_after(const Waiting& x, const Waiting& y);
  void become_heap();

  /// As long as each comes after the last: those from first_ on, in order. From then on a heap, and
  /// first_ is 0.
  std::vector<Waiting> waiting_;
  std::size_t first_{0};
  bool is_queue_{true};
};

/// Shares out work step after step in memory that it keeps.
class WorkSharing {
 public:
  /// Brings every pair to its list's least level; which pair comes first does not matter here.
  /// `work_before` was done already and is part of the floor. Returns the places of those that are
  /// not resolved yet, until the next call.
  std::span<const std::size_t> do_floor(std::span<RefinedPair> pairs,
                                        const std::vector<PriorityList>& lists,
                                        const RefinementSettings& settings = {});

  /// After do_floor() of the same: goes on until all pairs are resolved or `meter` refuses. `order`
  /// are the places of all pairs, by list and by falling priority within each, or of those that are
  /// not resolved where there is one list; none when all are. A pair whose next block is refused
  /// gives way to the next of its list. The result stays until the next call.
  const WorkDone& refine(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
                         std::span<const std::size_t> order, WorkMeter& meter,
                         const RefinementSettings& settings = {});

 private:
  WorkLedger ledger_;
  std::vector<std::size_t> unresolved_;
  std::array<WaitingPairs, kMostLists> waiting_;
  WorkDone done_;
};

}  // namespace impetus::inline collision
