// Lists by shares of a step's pairs.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/scheduling/list_rules.hpp"
#include "engine/scheduling/solved_thresholds.hpp"

namespace impetus::inline scheduling {

/// A pair's rank by the metric decides. Each limit is the share of the step's pairs that its list
/// takes, in [0, 1], together at most 1. Of equal measures the pair first in the broad phase's
/// order has the higher rank, so a share may part them.
class ShareLists final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return kPriorityTerm; }
  [[nodiscard]] bool has_limits() const override { return true; }

  [[nodiscard]] std::string problem(std::size_t lists, const std::vector<double>& limits,
                                    const PriorityMetric& /*metric*/) const override {
    return limits.size() == lists - 1 ? problem_of_shares(limits)
                                      : "expected " + std::to_string(lists - 1) +
                                            " pair shares, got " + std::to_string(limits.size());
  }

  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& input,
            std::vector<MeasuredPair>& pairs) const override {
    std::sort(pairs.begin(), pairs.end(), has_priority);
    std::size_t first = 0;
    double sum = 0.0;
    for (std::size_t list = 0; list <= input.limits.size(); ++list) {
      const bool is_last = list == input.limits.size();
      sum += is_last ? 0.0 : input.limits[list];
      const std::size_t end = is_last ? pairs.size() : cut_at(sum, pairs.size());
      for (; first < end; ++first) {
        pairs[first].scheduled.list = static_cast<int>(list);
      }
    }
  }
};

}  // namespace impetus::inline scheduling
