// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority_lists.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/solved_thresholds.hpp"

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

/// The first of the ranks to list 0, and so on; the pairs keep their order.
void list_by_rank(const std::vector<double>& pair_shares, std::vector<MeasuredPair>& pairs) {
  std::vector<std::size_t> ranked(pairs.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::stable_sort(ranked.begin(), ranked.end(), [&pairs](std::size_t x, std::size_t y) {
    return pairs[x].priority > pairs[y].priority;
  });
  const std::vector<std::size_t> cuts = cuts_for(pair_shares, pairs.size());
  std::size_t list = 0;
  for (std::size_t rank = 0; rank < ranked.size(); ++rank) {
    while (list < cuts.size() && rank >= cuts[list]) {
      ++list;
    }
    pairs[ranked[rank]].scheduled.list = static_cast<int>(list);
  }
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
  const std::size_t thresholds = schedule.rule == ListRule::kThresholds ? lists - 1 : 0;
  if (schedule.thresholds.size() != thresholds) {
    return expected(std::to_string(thresholds) + " thresholds",
                    std::to_string(schedule.thresholds.size()));
  }
  const std::size_t pair_shares = schedule.rule == ListRule::kPairShares ? lists - 1 : 0;
  if (schedule.pair_shares.size() != pair_shares) {
    return expected(std::to_string(pair_shares) + " pair shares",
                    std::to_string(schedule.pair_shares.size()));
  }
  if (const std::string problem = problem_of_shares(schedule.pair_shares); !problem.empty()) {
    return "schedule: " + problem;
  }
  if (schedule.persistence_steps < 0) {
    return expected("a persistence of at least 0 steps",
                    std::to_string(schedule.persistence_steps));
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

std::vector<MeasuredPair> measured(const std::vector<PairBounds>& bounds, const Schedule& schedule,
                                   const Viewer& viewer, const Fixation& fixation,
                                   const std::optional<GazeRegion>& region) {
  const PriorityMetric& metric = metric_of(schedule);
  std::vector<MeasuredPair> pairs;
  pairs.reserve(bounds.size());
  for (const PairBounds& candidate : bounds) {
    const double measure = metric.measure(candidate, viewer, fixation);
    int list = 0;
    if (schedule.rule == ListRule::kRegion) {
      list = region && inside(*region, candidate, viewer) ? 0 : 1;
    } else if (schedule.rule == ListRule::kThresholds) {
      list = list_by_threshold(schedule, metric, measure);
    }
    pairs.push_back({{candidate.pair, list}, metric.priority(measure)});
  }
  if (schedule.rule == ListRule::kPairShares) {
    list_by_rank(schedule.pair_shares, pairs);
  }
  return pairs;
}

std::vector<ScheduledPair> in_order(std::vector<MeasuredPair> pairs) {
  std::stable_sort(pairs.begin(), pairs.end(), [](const MeasuredPair& x, const MeasuredPair& y) {
    return x.scheduled.list != y.scheduled.list ? x.scheduled.list < y.scheduled.list
                                                : x.priority > y.priority;
  });
  std::vector<ScheduledPair> ordered;
  ordered.reserve(pairs.size());
  for (const MeasuredPair& pair : pairs) {
    ordered.push_back(pair.scheduled);
  }
  return ordered;
}

std::vector<ScheduledPair> scheduled(const std::vector<PairBounds>& bounds,
                                     const Schedule& schedule, const Viewer& viewer,
                                     const Fixation& fixation,
                                     const std::optional<GazeRegion>& region) {
  return in_order(measured(bounds, schedule, viewer, fixation, region));
}

}  // namespace impetus
