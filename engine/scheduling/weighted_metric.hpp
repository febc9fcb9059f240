// A weighted sum of other metrics, each brought from its own unit to [0, 1].
//
//   Σ weight · clamp((measure − relaxed) / (urgent − relaxed), 0, 1)
//
// Which way a metric runs is said by its two ends, whatever its own direction is.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "engine/scheduling/metrics.hpp"

namespace impetus::inline scheduling {

/// From 0 to the sum of the weights, large first.
class WeightedMetric final : public PriorityMetric {
 public:
  /// Throws std::invalid_argument as make_metric("weighted", options).
  explicit WeightedMetric(const MetricOptions& options);
  /// Those that any of the sum's metrics looks at.
  [[nodiscard]] unsigned terms() const override;
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& fixation) const override;

 private:
  /// A metric, its weight, and between which values it falls from 1 to 0.
  struct Term {
    std::shared_ptr<const PriorityMetric> metric;
    double weight;
    double urgent;
    double relaxed;
  };
  std::vector<Term> terms_;
};

}  // namespace impetus::inline scheduling
