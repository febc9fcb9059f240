// SPDX-License-Identifier: MIT
#include "engine/collision/list_refinement.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/collision/list_shares.hpp"
#include "engine/collision/waiting_pairs.hpp"

namespace impetus {
namespace {

/// Brings every pair to its list's least level.
void do_floor(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
              WorkLedger& ledger) {
  for (std::size_t index = 0; index < pairs.size(); ++index) {
    RefinedPair& pair = pairs[index];
    std::int64_t tests = 1;  // of the roots
    const int least_level = lists[static_cast<std::size_t>(pair.list)].least_level;
    while (pair.refinement.level() < least_level && !pair.refinement.resolved()) {
      tests += pair.refinement.next_block();
      pair.refinement.refine_one_block();
    }
    ledger.note(pair, index, tests);
  }
}

/// The rounds after the floor.
class Rounds {
 public:
  Rounds(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
         const RefinementSettings& settings, const PhaseCosts& costs, WorkLedger& ledger,
         std::array<WaitingPairs, kMostLists>& waiting)
      : pairs_(pairs),
        settings_(settings),
        costs_(costs),
        ledger_(ledger),
        shares_(lists),
        waiting_(waiting) {
    for (WaitingPairs& of_list : waiting_) {
      of_list.clear();
    }
    // With one list it decides nothing that pairs which need no work wait for it.
    for (std::size_t index = 0; index < pairs.size(); ++index) {
      if (lists.size() > 1 || !pairs[index].refinement.resolved()) {
        enqueue(index);
      }
    }
  }

  void run(WorkMeter& meter, WorkDone& done) {
    while (waiting_count_ > 0) {
      const std::size_t list = shares_.next_list(waits_, done.by_list);
      const std::size_t index = waiting_[list].next();
      PairRefinement& refinement = pairs_[index].refinement;
      if (refinement.resolved() || !granted(index, meter, done)) {
        dequeue(list);
        continue;
      }
      const int level = refinement.level();
      const std::int64_t tests = refinement.next_block();
      refinement.refine_one_block();
      ledger_.note(pairs_[index], index, tests);
      if (!done.by_list.empty()) {
        done.by_list[list] += costs_.of_tests(pairs_[index], tests);
      }
      // Where it is served by its place alone, a finer level changes nothing.
      if (refinement.level() != level && settings_.traversal != Traversal::kDepthFirst) {
        dequeue(list);
        enqueue(index);
      }
    }
  }

 private:
  bool granted(std::size_t index, WorkMeter& meter, WorkDone& done) {
    const WorkLedger::Demand demand = ledger_.for_next_block(pairs_[index], index);
    done.granted = std::max(done.granted, meter.request(demand.total, demand.reserved));
    if (done.granted < demand.total) {
      return false;
    }
    done.peak = std::max(done.peak, demand.total);
    return true;
  }

  void enqueue(std::size_t index) {
    const auto list = static_cast<std::size_t>(pairs_[index].list);
    waiting_[list].add(index, urgency(pairs_[index], settings_.traversal, costs_));
    waits_[list] = true;
    ++waiting_count_;
  }

  void dequeue(std::size_t list) {
    waiting_[list].remove_next();
    waits_[list] = !waiting_[list].empty();
    --waiting_count_;
  }

  std::span<RefinedPair> pairs_;
  const RefinementSettings& settings_;
  const PhaseCosts& costs_;
  WorkLedger& ledger_;
  ListShares shares_;
  std::array<WaitingPairs, kMostLists>& waiting_;
  std::array<bool, kMostLists> waits_{};
  std::size_t waiting_count_{0};
};

}  // namespace

const WorkDone& ListRefinement::refine(std::span<RefinedPair> pairs,
                                       const std::vector<PriorityList>& lists, WorkMeter& meter,
                                       const RefinementSettings& settings) {
  const PhaseCosts costs(settings.costs, settings.contacts);
  ledger_.begin(costs, pairs.size(), settings.work_before);
  do_floor(pairs, lists, ledger_);
  done_.floor = ledger_.total();
  done_.peak = done_.floor;
  done_.granted = meter.request(ledger_.total(), ledger_.reserved());
  done_.by_list.assign(lists.size() > 1 ? lists.size() : 0, 0);
  Rounds(pairs, lists, settings, costs, ledger_, waiting_).run(meter, done_);
  done_.spent = ledger_.spent();
  done_.reserved = ledger_.reserved();
  return done_;
}

WorkDone refine_by_lists(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
                         WorkMeter& meter, const RefinementSettings& settings) {
  return ListRefinement().refine(pairs, lists, meter, settings);
}

}  // namespace impetus
