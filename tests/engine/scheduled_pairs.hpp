// A schedule's whole order of some pairs, whoever needs it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/priority_lists.hpp"

namespace impetus {

/// The pairs by list, and by falling priority within each; equal priorities keep their order.
inline std::vector<ScheduledPair> scheduled(const std::vector<PairBounds>& bounds,
                                            const Schedule& schedule, const Viewer& viewer,
                                            const Fixation& fixation,
                                            const std::optional<GazeRegion>& region) {
  const PriorityMetric& metric = metric_of(schedule);
  std::vector<MeasuredPair> pairs;
  put_into_lists(bounds, schedule, viewer, fixation, region, pairs);
  for (MeasuredPair& pair : pairs) {
    pair.priority = metric.priority(metric.measure(bounds[at(pair.place)], viewer, fixation));
  }
  std::sort(pairs.begin(), pairs.end(), goes_before);
  std::vector<ScheduledPair> ordered;
  for (const MeasuredPair& pair : pairs) {
    ordered.push_back(pair.scheduled);
  }
  return ordered;
}

}  // namespace impetus
