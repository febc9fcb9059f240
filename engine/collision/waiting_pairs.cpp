// SPDX-License-Identifier: MIT
#include "engine/collision/waiting_pairs.hpp"

#include <algorithm>

#include "engine/numerics/trigonometry.hpp"

namespace impetus {
namespace {

/// Degrees that the next level is expected to take off the visible gap, per unit of work.
double expected_gain(const RefinedPair& pair, const PhaseCosts& costs) {
  const PairRefinement& refinement = pair.refinement;
  if (refinement.resolved()) {
    return 0.0;
  }
  const int level = refinement.level();
  const double removed_m = refinement.fit_error_m(level) - refinement.fit_error_m(level + 1);
  const double visible_deg = degrees(2.0 * atan2_rad(0.5 * removed_m, pair.eye_distance_m));
  const double cost = static_cast<double>(costs.of_tests(pair, refinement.tests_of_next_level()));
  return visible_deg * refinement.likeliest_collision() / cost;
}

}  // namespace

double urgency(const RefinedPair& pair, Traversal traversal, const PhaseCosts& costs) {
  switch (traversal) {
    case Traversal::kDepthFirst:
      return 0.0;
    case Traversal::kBreadthFirst:
      return -static_cast<double>(pair.refinement.level());
    case Traversal::kBestFirst:
      break;
  }
  const double gain = expected_gain(pair, costs);
  return gain > 0.0 ? gain : 0.0;  // also for what is not a number, which has no place in an order
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

}  // namespace impetus
