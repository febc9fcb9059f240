// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority_lists.hpp"

#include <algorithm>
#include <cmath>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/solved_thresholds.hpp"

namespace impetus::inline scheduling {
namespace {

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

int list_by_region(const std::optional<GazeRegion>& region, const PairBounds& bounds,
                   const Viewer& viewer) {
  return region && inside(*region, bounds, viewer) ? 0 : 1;
}

/// A total order, whatever the priorities are.
bool has_priority(const MeasuredPair& x, const MeasuredPair& y) {
  const bool x_is_number = !std::isnan(x.priority);
  const bool y_is_number = !std::isnan(y.priority);
  if (x_is_number != y_is_number) {
    return x_is_number;
  }
  if (x_is_number && x.priority != y.priority) {
    return x.priority > y.priority;
  }
  return x.place < y.place;
}

/// The first of the ranks to list 0, and so on.
void list_by_rank(const std::vector<double>& pair_shares, std::vector<MeasuredPair>& pairs) {
  std::sort(pairs.begin(), pairs.end(), has_priority);
  std::size_t first = 0;
  double sum = 0.0;
  for (std::size_t list = 0; list <= pair_shares.size(); ++list) {
    const bool is_last = list == pair_shares.size();
    sum += is_last ? 0.0 : pair_shares[list];
    const std::size_t end = is_last ? pairs.size() : cut_at(sum, pairs.size());
    for (; first < end; ++first) {
      pairs[first].scheduled.list = static_cast<int>(list);
    }
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

const PriorityMetric& metric_of(const Schedule& schedule) {
  static const std::shared_ptr<const PriorityMetric> nearest_first = make_metric("distance");
  return schedule.metric ? *schedule.metric : *nearest_first;
}

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

void measure(const std::vector<PairBounds>& bounds, const Schedule& schedule, const Viewer& viewer,
             const Fixation& fixation, const std::optional<GazeRegion>& region,
             std::vector<MeasuredPair>& pairs) {
  const PriorityMetric& metric = metric_of(schedule);
  pairs.clear();
  for (const PairBounds& candidate : bounds) {
    const double measured = metric.measure(candidate, viewer, fixation);
    int list = 0;
    if (schedule.rule == ListRule::kRegion) {
      list = list_by_region(region, candidate, viewer);
    } else if (schedule.rule == ListRule::kThresholds) {
      list = list_by_threshold(schedule, metric, measured);
    }
    const auto place = static_cast<std::int32_t>(pairs.size());
    pairs.push_back({{candidate.pair, list}, metric.priority(measured), place});
  }
  if (schedule.rule == ListRule::kPairShares) {
    list_by_rank(schedule.pair_shares, pairs);
  }
}

void put_into_lists(const std::vector<PairBounds>& bounds, const Schedule& schedule,
                    const Viewer& viewer, const std::optional<GazeRegion>& region,
                    std::vector<MeasuredPair>& pairs) {
  pairs.clear();
  for (const PairBounds& candidate : bounds) {
    const int list =
        schedule.rule == ListRule::kRegion ? list_by_region(region, candidate, viewer) : 0;
    pairs.push_back({{candidate.pair, list}, 0.0, static_cast<std::int32_t>(pairs.size())});
  }
}

bool goes_before(const MeasuredPair& x, const MeasuredPair& y) {
  return x.scheduled.list != y.scheduled.list ? x.scheduled.list < y.scheduled.list
                                              : has_priority(x, y);
}

std::vector<ScheduledPair> scheduled(const std::vector<PairBounds>& bounds,
                                     const Schedule& schedule, const Viewer& viewer,
                                     const Fixation& fixation,
                                     const std::optional<GazeRegion>& region) {
  std::vector<MeasuredPair> pairs;
  measure(bounds, schedule, viewer, fixation, region, pairs);
  std::sort(pairs.begin(), pairs.end(), goes_before);
  std::vector<ScheduledPair> ordered;
  ordered.reserve(pairs.size());
  for (const MeasuredPair& pair : pairs) {
    ordered.push_back(pair.scheduled);
  }
  return ordered;
}

}  // namespace impetus::inline scheduling
