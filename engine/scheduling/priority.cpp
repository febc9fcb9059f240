// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority.hpp"

#include <algorithm>

namespace impetus {

double DistancePriority::priority(const PairBounds& bounds, const Viewer& viewer) const {
  return -(0.5 * (bounds.a.centre + bounds.b.centre) - viewer.eye).norm();
}

std::vector<BodyPair> prioritised(const std::vector<PairBounds>& bounds,
                                  const PriorityMetric& metric, const Viewer& viewer) {
  struct Ranked {
    BodyPair pair;
    double priority;
  };
  std::vector<Ranked> ranked;
  ranked.reserve(bounds.size());
  for (const PairBounds& candidate : bounds) {
    ranked.push_back({candidate.pair, metric.priority(candidate, viewer)});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Ranked& x, const Ranked& y) { return x.priority > y.priority; });
  std::vector<BodyPair> pairs;
  pairs.reserve(ranked.size());
  for (const Ranked& entry : ranked) {
    pairs.push_back(entry.pair);
  }
  return pairs;
}

}  // namespace impetus
