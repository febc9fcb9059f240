// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority_lists.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/scheduling/metrics.hpp"

namespace impetus::inline scheduling {
namespace {

std::string expected(const std::string& what, const std::string& got) {
  return "schedule: expected " + what + ", got " + got;
}

std::string problem_of(const PriorityList& list) {
  if (!(list.share >= 0.0) || !std::isfinite(list.share)) {
    return expected("a share of at least 0", std::to_string(list.share));
  }
  if (list.least_level < 0 || list.least_level > list.greatest_level) {
    return expected(
        "0 <= least level <= greatest level",
        std::to_string(list.least_level) + " and " + std::to_string(list.greatest_level));
  }
  return "";
}

}  // namespace

const PriorityMetric& metric_of(const Schedule& schedule) {
  static const std::shared_ptr<const PriorityMetric> nearest_first = make_metric("distance");
  return schedule.metric ? *schedule.metric : *nearest_first;
}

std::string problem_of(const Schedule& schedule) {
  const std::size_t lists = schedule.lists.size();
  if (lists < 1 || lists > kMostLists) {
    return expected("1 to " + std::to_string(kMostLists) + " lists", std::to_string(lists));
  }
  double shares = 0.0;
  for (const PriorityList& list : schedule.lists) {
    if (std::string problem = problem_of(list); !problem.empty()) {
      return problem;
    }
    shares += list.share;
  }
  if (!(shares > 0.0)) {
    return expected("a list with a share above 0", "none");
  }
  if (schedule.rule == nullptr || schedule.traversal == nullptr) {
    return expected(schedule.rule == nullptr ? "a list rule" : "a traversal", "none");
  }
  const std::string problem = schedule.rule->problem(lists, schedule.limits, metric_of(schedule));
  if (!problem.empty()) {
    return "schedule: " + problem;
  }
  if (schedule.persistence_steps < 0) {
    return expected("a persistence of at least 0 steps",
                    std::to_string(schedule.persistence_steps));
  }
  return "";
}

namespace {

/// A rule may be somebody's own.
void require_lists(const std::vector<MeasuredPair>& pairs, std::size_t count) {
  for (const MeasuredPair& pair : pairs) {
    const int list = pair.scheduled.list;
    if (list < 0 || static_cast<std::size_t>(list) >= count) {
      throw std::out_of_range("schedule: expected a list from 0 to " + std::to_string(count - 1) +
                              " of the list rule, got " + std::to_string(list));
    }
  }
}

}  // namespace

void put_into_lists(const std::vector<PairBounds>& bounds, const Schedule& schedule,
                    const Viewer& viewer, const Fixation& fixation,
                    const std::optional<GazeRegion>& region, std::vector<MeasuredPair>& pairs) {
  const PriorityMetric& metric = metric_of(schedule);
  const bool measures = metric_decides_lists(schedule);
  pairs.clear();
  for (const PairBounds& candidate : bounds) {
    const double priority =
        measures ? metric.priority(metric.measure(candidate, viewer, fixation)) : 0.0;
    const auto place = static_cast<std::int32_t>(pairs.size());
    pairs.push_back({{candidate.pair, 0}, priority, place, measures});
  }
  if (schedule.lists.size() > 1) {
    schedule.rule->part(bounds, {metric, schedule.limits, viewer, region}, pairs);
    require_lists(pairs, schedule.lists.size());
  }
}

}  // namespace impetus::inline scheduling
