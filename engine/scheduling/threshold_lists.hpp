// Lists by thresholds of the metric. (Dingliana 2002, sec. 5.1.2)
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/list_rules.hpp"

namespace impetus::inline scheduling {

/// A pair falls into the first list whose limit it meets, or else into the last. Limits are in the
/// metric's own unit, from high priority to low.
class ThresholdLists final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return kPriorityTerm; }
  [[nodiscard]] bool has_limits() const override { return true; }

  [[nodiscard]] std::string problem(std::size_t lists, const std::vector<double>& limits,
                                    const PriorityMetric& metric) const override {
    if (limits.size() != lists - 1) {
      return "expected " + std::to_string(lists - 1) + " thresholds, got " +
             std::to_string(limits.size());
    }
    for (std::size_t i = 0; i < limits.size(); ++i) {
      if (!std::isfinite(limits[i]) || (i > 0 && !metric.meets(limits[i - 1], limits[i]))) {
        return "expected finite thresholds from high priority to low, got " +
               std::to_string(limits[i]) + " as number " + std::to_string(i + 1);
      }
    }
    return "";
  }

  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& input,
            std::vector<MeasuredPair>& pairs) const override {
    for (MeasuredPair& pair : pairs) {
      const double measured = input.metric.priority(pair.priority);  // its sign turned back
      int& list = pair.scheduled.list;
      while (at(list) < input.limits.size() &&
             !input.metric.meets(measured, input.limits[at(list)])) {
        ++list;
      }
    }
  }
};

}  // namespace impetus::inline scheduling
