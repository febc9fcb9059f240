// SPDX-License-Identifier: MIT
#include "engine/collision/budgeted_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include "engine/scheduling/perceived_metric.hpp"

namespace impetus::inline collision {
namespace {

/// Which priority list gets the next block of work: the one furthest behind its share. What a
/// finished list leaves of its share flows on to the next list in order. (Dingliana 2002,
/// sec. 5.1.2)
class ListShares {
 public:
  /// `lists` must outlive this.
  explicit ListShares(const std::vector<PriorityList>& lists) : lists_(&lists) {
    for (const PriorityList& list : lists) {
      sum_ += list.share;
    }
  }

  /// `waits` says of each list whether any of its pairs waits for work, `work` how much it has got;
  /// `work` may be empty when there is one list. Precondition: some list waits.
  [[nodiscard]] std::size_t next_list(const std::array<bool, kMostLists>& waits,
                                      const std::vector<std::int64_t>& work) const {
    const std::size_t count = lists_->size();
    if (count == 1) {
      return 0;
    }
    const std::array<double, kMostLists> behind = units_behind(waits, work);
    const auto goes_before = [&](std::size_t list, std::size_t other) {
      return behind[list] > behind[other] ||
             (behind[list] == behind[other] && (*lists_)[list].share > (*lists_)[other].share);
    };
    std::size_t best = count;
    for (std::size_t list = 0; list < count; ++list) {
      if (waits[list] && (best == count || goes_before(list, best))) {
        best = list;
      }
    }
    return best;
  }

 private:
  /// What each list is owed: its share of what was spent, and what finished lists left.
  [[nodiscard]] std::array<double, kMostLists> units_behind(
      const std::array<bool, kMostLists>& waits, const std::vector<std::int64_t>& work) const {
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

  const std::vector<PriorityList>* lists_;
  double sum_{0.0};
};

/// What a traversal may ask of a pair.
class Progress final : public PairProgress {
 public:
  Progress(const RefinedPair& pair, const PhaseCosts& costs) : pair_(pair), costs_(costs) {}

  [[nodiscard]] bool resolved() const override { return pair_.refinement.resolved(); }
  [[nodiscard]] int level() const override { return pair_.refinement.level(); }
  [[nodiscard]] int finest_level() const override { return pair_.refinement.finest_level(); }
  [[nodiscard]] double fit_error_m(int level) const override {
    return pair_.refinement.fit_error_m(level);
  }
  [[nodiscard]] double likeliest_collision() const override {
    return pair_.refinement.likeliest_collision();
  }
  [[nodiscard]] double deepest_overlap_m() const override {
    return pair_.refinement.deepest_overlap_m();
  }
  [[nodiscard]] std::int64_t work_of_next_level() const override {
    return costs_.of_tests(pair_, pair_.refinement.tests_of_next_level());
  }
  [[nodiscard]] double eye_distance_m() const override { return pair_.eye_distance_m; }
  [[nodiscard]] double acuity() const override { return pair_.acuity; }
  [[nodiscard]] std::optional<double> noticed(double gap_deg) const override {
    constexpr double kArcminPerDegree = 60.0;
    return pair_.noticing == nullptr
               ? std::nullopt
               : std::optional(noticed_share(*pair_.noticing, kArcminPerDegree * gap_deg,
                                             pair_.noticed_arcmin));
  }

 private:
  const RefinedPair& pair_;
  const PhaseCosts& costs_;
};

/// Brings every pair to its list's least level; lists those that are not resolved yet.
void bring_to_least(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
                    WorkLedger& ledger, std::vector<std::size_t>& unresolved) {
  unresolved.clear();
  for (std::size_t index = 0; index < pairs.size(); ++index) {
    RefinedPair& pair = pairs[index];
    std::int64_t tests = pair.looked_at ? 1 : 0;  // of the roots
    const int least_level = lists[static_cast<std::size_t>(pair.list)].least_level;
    while (pair.refinement.level() < least_level && !pair.refinement.resolved()) {
      tests += pair.refinement.next_block();
      pair.refinement.refine_one_block();
    }
    ledger.note(pair, index, tests);
    if (!pair.refinement.resolved()) {
      unresolved.push_back(index);
    }
  }
}

/// The rounds after the floor.
class Rounds {
 public:
  Rounds(std::span<RefinedPair> pairs, const std::vector<PriorityList>& lists,
         std::span<const std::size_t> order, const RefinementSettings& settings,
         const PhaseCosts& costs, WorkLedger& ledger, std::array<WaitingPairs, kMostLists>& waiting)
      : pairs_(pairs),
        order_(order),
        traversal_(*settings.traversal),
        costs_(costs),
        ledger_(ledger),
        shares_(lists),
        waiting_(waiting) {
    for (WaitingPairs& of_list : waiting_) {
      of_list.clear();
    }
    // With one list it decides nothing that pairs which need no work wait for it.
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      if (lists.size() > 1 || !pairs[order[rank]].refinement.resolved()) {
        enqueue(rank);
      }
    }
  }

  void run(WorkMeter& meter, WorkDone& done) {
    PhaseWork tests(meter, WorkPhase::kTests, done.grants);
    while (waiting_count_ > 0 && something_fits(tests)) {
      const std::size_t list = shares_.next_list(waits_, done.by_list);
      const std::size_t rank = waiting_[list].next();
      const std::size_t index = order_[rank];
      PairRefinement& refinement = pairs_[index].refinement;
      if (refinement.resolved() || !granted(index, meter, tests, done)) {
        dequeue(list);
        continue;
      }
      const int level = refinement.level();
      const std::int64_t block = refinement.next_block();
      refinement.refine_one_block();
      ledger_.note(pairs_[index], index, block);
      if (!done.by_list.empty()) {
        done.by_list[list] += costs_.of_tests(pairs_[index], block);
      }
      // Where it is served by its place alone, a finer level changes nothing.
      if (refinement.level() != level && looks_at_progress_) {
        dequeue(list);
        enqueue(rank);
      }
    }
  }

 private:
  bool granted(std::size_t index, WorkMeter& meter, PhaseWork& tests, WorkDone& done) {
    const WorkLedger::Demand demand = ledger_.for_next_block(pairs_[index], index);
    if (!tests.spend(costs_.of_tests(pairs_[index], pairs_[index].refinement.next_block()),
                     demand.reserved)) {
      return false;
    }
    done.granted = std::max(done.granted,
                            meter.request(WorkPhase::kRefinement, demand.total, demand.reserved));
    if (done.granted < demand.total) {
      return false;
    }
    done.peak = std::max(done.peak, demand.total);
    return true;
  }

  /// Whether a pair waits whose next block fits into what is left of the tests once more of them
  /// were refused: looked for when that has changed.
  bool something_fits(const PhaseWork& tests) {
    const std::int64_t left = tests.granted() - tests.done();
    if (!tests.refused() || left == left_when_looked_) {
      return true;
    }
    left_when_looked_ = left;
    const auto fits = [&](std::size_t rank) {
      const RefinedPair& pair = pairs_[order_[rank]];
      return !pair.refinement.resolved() &&
             costs_.of_tests(pair, pair.refinement.next_block()) <= left;
    };
    return std::any_of(waiting_.begin(), waiting_.end(),
                       [&](const WaitingPairs& of_list) { return of_list.any(fits); });
  }

  void enqueue(std::size_t rank) {
    const RefinedPair& pair = pairs_[order_[rank]];
    const auto list = static_cast<std::size_t>(pair.list);
    waiting_[list].add(rank, urgency(pair, traversal_, costs_));
    waits_[list] = true;
    ++waiting_count_;
  }

  void dequeue(std::size_t list) {
    waiting_[list].remove_next();
    waits_[list] = !waiting_[list].empty();
    --waiting_count_;
  }

  std::span<RefinedPair> pairs_;
  std::span<const std::size_t> order_;
  const Traversal& traversal_;
  const PhaseCosts& costs_;
  WorkLedger& ledger_;
  ListShares shares_;
  bool looks_at_progress_{(traversal_.terms() & kProgressTerm) != 0};
  std::array<WaitingPairs, kMostLists>& waiting_;
  std::array<bool, kMostLists> waits_{};
  std::size_t waiting_count_{0};
  std::int64_t left_when_looked_{-1};
};

}  // namespace

double urgency(const RefinedPair& pair, const Traversal& traversal, const PhaseCosts& costs) {
  const double urgency = traversal.urgency(Progress(pair, costs));
  return std::isnan(urgency) ? 0.0 : urgency;  // what is no number has no place in an order
}

bool WaitingPairs::comes_after(const Waiting& x, const Waiting& y) {
  return x.urgency < y.urgency || (x.urgency == y.urgency && x.index > y.index);
}

void WaitingPairs::add(std::size_t index, double urgency) {
  const Waiting added{urgency, index};
  if (is_queue_ && !empty() && comes_after(waiting_.back(), added)) {
    become_heap();
  }
  waiting_.push_back(added);
  if (!is_queue_) {
    std::push_heap(waiting_.begin(), waiting_.end(), comes_after);
  }
}

void WaitingPairs::become_heap() {
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
  is_queue_ = false;
  std::make_heap(waiting_.begin(), waiting_.end(), comes_after);
}

void WaitingPairs::remove_next() {
  if (is_queue_) {
    ++first_;
    return;
  }
  std::pop_heap(waiting_.begin(), waiting_.end(), comes_after);
  waiting_.pop_back();
}

std::span<const std::size_t> WorkSharing::do_floor(std::span<RefinedPair> pairs,
                                                   const std::vector<PriorityList>& lists,
                                                   const RefinementSettings& settings) {
  const PhaseCosts costs(settings.costs, settings.contacts);
  ledger_.begin(costs, pairs.size(), settings.work_before);
  bring_to_least(pairs, lists, ledger_, unresolved_);
  return unresolved_;
}

const WorkDone& WorkSharing::refine(std::span<RefinedPair> pairs,
                                    const std::vector<PriorityList>& lists,
                                    std::span<const std::size_t> order, WorkMeter& meter,
                                    const RefinementSettings& settings) {
  done_.floor = ledger_.total();
  done_.peak = done_.floor;
  done_.granted = meter.request(WorkPhase::kRefinement, ledger_.total(), ledger_.reserved());
  done_.grants = {};
  done_.by_list.assign(lists.size() > 1 ? lists.size() : 0, 0);
  if (!order.empty()) {
    const PhaseCosts costs(settings.costs, settings.contacts);
    Rounds(pairs, lists, order, settings, costs, ledger_, waiting_).run(meter, done_);
  }
  done_.spent = ledger_.spent();
  done_.reserved = ledger_.reserved();
  return done_;
}

}  // namespace impetus::inline collision
