// SPDX-License-Identifier: MIT
#include "engine/collision/waiting_pairs.hpp"

#include <algorithm>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline collision {
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

/// Metres of gap that are expected to open until `level`.
double expected_gap_m(const PairRefinement& refinement, int level, double overlap_m) {
  const double closer_m =
      refinement.fit_error_m(refinement.level()) - refinement.fit_error_m(level);
  if (!(closer_m > overlap_m)) {
    return 0.0;
  }
  const double beyond_m = closer_m - overlap_m;
  return 0.5 * beyond_m * beyond_m / closer_m;
}

/// Degrees at the fovea that finer levels are expected to take off what shows, per unit of work.
double expected_visible_gain(const RefinedPair& pair, const PhaseCosts& costs) {
  const PairRefinement& refinement = pair.refinement;
  if (refinement.resolved()) {
    return 0.0;
  }
  const double overlap_m = refinement.deepest_overlap_m();
  double gap_per_level_m = 0.0;
  for (int level = refinement.level() + 1; level <= refinement.finest_level(); ++level) {
    gap_per_level_m = std::max(gap_per_level_m, expected_gap_m(refinement, level, overlap_m) /
                                                    (level - refinement.level()));
  }
  const double visible_deg = degrees(2.0 * atan2_rad(0.5 * gap_per_level_m, pair.eye_distance_m));
  const double cost = static_cast<double>(costs.of_tests(pair, refinement.tests_of_next_level()));
  return pair.acuity * visible_deg / cost;
}

double expected(const RefinedPair& pair, Traversal traversal, const PhaseCosts& costs) {
  return traversal == Traversal::kVisibleFirst ? expected_visible_gain(pair, costs)
                                               : expected_gain(pair, costs);
}

}  // namespace

double urgency(const RefinedPair& pair, Traversal traversal, const PhaseCosts& costs) {
  switch (traversal) {
    case Traversal::kDepthFirst:
      return 0.0;
    case Traversal::kBreadthFirst:
      return -static_cast<double>(pair.refinement.level());
    case Traversal::kBestFirst:
    case Traversal::kVisibleFirst:
      break;
  }
  const double gain = expected(pair, traversal, costs);
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

}  // namespace impetus::inline collision
