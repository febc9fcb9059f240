// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority_lists.hpp"

#include <algorithm>
#include <cmath>

#include "engine/scheduling/metrics.hpp"

namespace impetus {
namespace {

const PriorityMetric& metric_of(const Schedule& schedule) {
  static const std::shared_ptr<const PriorityMetric> nearest_first = make_metric("distance");
  return schedule.metric ? *schedule.metric : *nearest_first;
}

int list_by_threshold(const Schedule& schedule, const PriorityMetric& metric, double measured) {
  int list = 0;
  for (const double threshold : schedule.thresholds) {
    if (metric.meets(measured, threshold)) {
      return list;
    }
    ++list;
  }
  return list;
}

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

bool inside(const GazeRegion& region, const PairBounds& bounds, const Viewer& viewer) {
  const Vector3 centre = on_screen(viewer, region.centre);
  return visual_angle_deg(viewer, collision_place(bounds), centre) <= region.radius_deg;
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
  if (schedule.rule == ListRule::kRegion && lists != 2) {
    return expected("two lists for a region", std::to_string(lists));
  }
  const std::size_t needed = schedule.rule == ListRule::kRegion ? 0 : lists - 1;
  if (schedule.thresholds.size() != needed) {
    return expected(std::to_string(needed) + " thresholds",
                    std::to_string(schedule.thresholds.size()));
  }
  const PriorityMetric& metric = metric_of(schedule);
  for (std::size_t i = 0; i < schedule.thresholds.size(); ++i) {
    if (!std::isfinite(schedule.thresholds[i]) ||
        (i > 0 && !metric.meets(schedule.thresholds[i - 1], schedule.thresholds[i]))) {
      return expected(
          "finite thresholds from high priority to low",
          std::to_string(schedule.thresholds[i]) + " as number " + std::to_string(i + 1));
    }
  }
  return "";
}

std::vector<ScheduledPair> scheduled(const std::vector<PairBounds>& bounds,
                                     const Schedule& schedule, const Viewer& viewer,
                                     const Fixation& fixation,
                                     const std::optional<GazeRegion>& region) {
  if (bounds.empty()) {
    return {};
  }
  struct Ranked {
    ScheduledPair scheduled;
    double priority;
  };
  const PriorityMetric& metric = metric_of(schedule);
  std::vector<Ranked> ranked;
  ranked.reserve(bounds.size());
  for (const PairBounds& candidate : bounds) {
    const double measured = metric.measure(candidate, viewer, fixation);
    int list = 0;
    if (schedule.rule == ListRule::kRegion) {
      list = region && inside(*region, candidate, viewer) ? 0 : 1;
    } else {
      list = list_by_threshold(schedule, metric, measured);
    }
    ranked.push_back({{candidate.pair, list}, metric.priority(measured)});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Ranked& x, const Ranked& y) {
    return x.scheduled.list != y.scheduled.list ? x.scheduled.list < y.scheduled.list
                                                : x.priority > y.priority;
  });
  std::vector<ScheduledPair> pairs;
  pairs.reserve(ranked.size());
  for (const Ranked& entry : ranked) {
    pairs.push_back(entry.scheduled);
  }
  return pairs;
}

}  // namespace impetus
