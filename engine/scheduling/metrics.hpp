// The metrics by name: each is a class and a row of the table in metrics.cpp, which says what it
// measures, in what unit, and from where to where.
// (Dingliana 2002, sec. 5.2.1; eq. 5.1, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// One metric's part of a weighted sum: 1 at `urgent` and beyond, 0 at `relaxed` and beyond, linear
/// between them, times `weight`.
struct WeightedTerm {
  std::string metric;
  double weight{1.0};
  double urgent{0.0};  ///< in the metric's own unit, as `relaxed`
  double relaxed{0.0};
};

/// What some metrics need beside their name.
struct MetricOptions {
  /// Eccentricity is measured from here, wherever the viewer looks: for metrics that takes_point().
  std::optional<ScreenPoint> point{};
  std::vector<WeightedTerm> terms{};  ///< of a weighted sum
  Noticing noticing{};                ///< of the metric perceived, alone or in a sum
};

/// The metric called `name`. Throws std::invalid_argument that lists the names there are, or says
/// what is wrong with the options.
std::shared_ptr<const PriorityMetric> make_metric(std::string_view name,
                                                  const MetricOptions& options = {});

/// Whether a metric has a use for MetricOptions::point; false for names there are not.
bool takes_point(std::string_view name);

/// Whether a metric is made of MetricOptions::terms, and needs some.
bool needs_terms(std::string_view name);

/// What the metric called `name` takes of them.
MetricOptions options_for(std::string_view name, const MetricOptions& all);

/// The names make_metric() takes, in alphabetical order.
std::vector<std::string_view> metric_names();

/// What each of them measures: "distance: m from the eye to the midpoint of the centres, the near
/// first. ..."
std::string metrics_in_words();

/// From where to where thresholds of a metric make sense, from the most urgent to the least.
struct MeasureRange {
  std::string_view unit;
  double urgent{0.0};
  double relaxed{100.0};
};

/// As it stands for names there are not.
MeasureRange measure_range(std::string_view name);

}  // namespace impetus::inline scheduling
