// Priority lists: which pairs get which share of a step's work, and how deep they may go.
//
//   pairs --metric, rule--> list 0 | list 1 | ... --shares--> its pairs --traversal--> refinement
//
// All good, all bad, tracked, random and yoked are all the same thing: which pairs fall into which
// list, and each list's least and greatest level. (Dingliana 2002, sec. 5.1.2 and 6.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/list_rules.hpp"
#include "engine/scheduling/traversals.hpp"

namespace impetus::inline scheduling {

inline constexpr int kMostLists = 16;
inline constexpr int kUnlimitedLevel = std::numeric_limits<int>::max();

/// What its pairs get of a step's work, and how deep they may go.
struct PriorityList {
  double share{1.0};   ///< of the step's work beyond the floor, relative to the other lists'
  int least_level{0};  ///< done whatever the budget, as part of the floor
  int greatest_level{kUnlimitedLevel};  ///< never exceeded
};

/// How the work of a step is shared. As it stands: one list, nearest first, pair after pair.
struct Schedule {
  std::shared_ptr<const PriorityMetric> metric;  ///< none: distance
  std::vector<PriorityList> lists = std::vector<PriorityList>(1);
  std::shared_ptr<const ListRule> rule = make_list_rule("thresholds");
  /// That the rule parts the lists by: one fewer than lists, or none for a rule without limits.
  std::vector<double> limits{};
  std::shared_ptr<const Traversal> traversal = make_traversal("depth-first");
  /// A pair that touches keeps the highest priority it had in this many steps before; 0: none.
  /// (Dingliana 2002, sec. 5.3.1)
  std::int64_t persistence_steps{0};
};

/// What is wrong with the schedule, as "schedule: expected ..., got ..."; empty when nothing is.
std::string problem_of(const Schedule& schedule);

/// The schedule's metric, or distance when it names none.
const PriorityMetric& metric_of(const Schedule& schedule);

/// Whether pairs must be measured to know their lists.
inline bool metric_decides_lists(const Schedule& schedule) {
  return schedule.lists.size() > 1 && (schedule.rule->terms() & kPriorityTerm) != 0;
}

/// Whether lists follow the step's region.
inline bool follows_region(const Schedule& schedule) {
  return (schedule.rule->terms() & kRegionTerm) != 0;
}

/// Gives each pair of `bounds` its list, and where the metric decides lists its priority: what
/// `pairs` held before is forgotten. They are in no order yet.
void put_into_lists(const std::vector<PairBounds>& bounds, const Schedule& schedule,
                    const Viewer& viewer, const Fixation& fixation,
                    const std::optional<GazeRegion>& region, std::vector<MeasuredPair>& pairs);

/// Whether x goes before y: by list, and by has_priority() within each.
inline bool goes_before(const MeasuredPair& x, const MeasuredPair& y) {
  return x.scheduled.list != y.scheduled.list ? x.scheduled.list < y.scheduled.list
                                              : has_priority(x, y);
}

}  // namespace impetus::inline scheduling
