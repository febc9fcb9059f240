// SPDX-License-Identifier: MIT
#include "engine/scheduling/metrics.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "engine/scheduling/distance_metric.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "engine/scheduling/named_kinds.hpp"
#include "engine/scheduling/size_metric.hpp"
#include "engine/scheduling/speed_metrics.hpp"
#include "engine/scheduling/visible_frequency.hpp"
#include "engine/scheduling/weighted_metric.hpp"

namespace impetus::inline scheduling {
namespace {

using Metric = std::shared_ptr<const PriorityMetric>;

/// What a metric is made of beside its name, as its constructor says.
template <typename T>
constexpr bool kTakesPoint = std::is_constructible_v<T, std::optional<ScreenPoint>>;
template <typename T>
constexpr bool kTakesOptions = std::is_constructible_v<T, const MetricOptions&>;

template <typename T>
Metric made(const MetricOptions& options) {
  if constexpr (kTakesOptions<T>) {
    return std::make_shared<const T>(options);
  } else if constexpr (kTakesPoint<T>) {
    return std::make_shared<const T>(options.point);
  } else {
    return std::make_shared<const T>();
  }
}

/// A metric by its name, and how one is made.
struct NamedMetric {
  std::string_view name;
  Metric (*make)(const MetricOptions&);
  bool takes_point;
  bool takes_terms;
};

template <typename T>
constexpr NamedMetric named(std::string_view name) {
  return {name, made<T>, kTakesPoint<T> || kTakesOptions<T>, kTakesOptions<T>};
}

/// In alphabetical order. A new metric is one line here.
constexpr NamedMetric kMetrics[] = {named<CollisionSpeedMetric>("collision-speed"),
                                    named<DistanceMetric>("distance"),
                                    named<EccentricityMetric>("eccentricity"),
                                    named<GapMetric>("gap"),
                                    named<GapBoundMetric>("gap-bound"),
                                    named<ProjectedCentresMetric>("projected-centres"),
                                    named<ProjectedGapMetric>("projected-gap"),
                                    named<SizeMetric>("size"),
                                    named<VelocityMetric>("velocity"),
                                    named<VisibleFrequencyMetric>("visible-frequency"),
                                    named<WeightedMetric>("weighted")};

const NamedMetric* found(std::string_view name) {
  const NamedMetric* metric =
      std::find_if(std::begin(kMetrics), std::end(kMetrics),
                   [name](const NamedMetric& each) { return each.name == name; });
  return metric == std::end(kMetrics) ? nullptr : metric;
}

[[noreturn]] void refuse(const std::string& what, const std::string& got) {
  throw std::invalid_argument("scheduler: expected " + what + ", got " + got);
}

}  // namespace

std::shared_ptr<const PriorityMetric> make_metric(std::string_view name,
                                                  const MetricOptions& options) {
  const NamedMetric* metric = found(name);
  if (metric == nullptr) {
    refuse("one of " + list_names(metric_names()), "\"" + std::string(name) + "\"");
  }
  if (options.point && !metric->takes_point) {
    refuse("no point, which \"" + std::string(name) + "\" has no use for", "one");
  }
  if (!options.terms.empty() && !metric->takes_terms) {
    refuse("no terms, which \"" + std::string(name) + "\" has no use for",
           std::to_string(options.terms.size()));
  }
  return metric->make(options);
}

bool takes_point(std::string_view name) {
  const NamedMetric* metric = found(name);
  return metric != nullptr && metric->takes_point;
}

bool needs_terms(std::string_view name) {
  const NamedMetric* metric = found(name);
  return metric != nullptr && metric->takes_terms;
}

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  for (const NamedMetric& metric : kMetrics) {
    names.push_back(metric.name);
  }
  return names;
}

}  // namespace impetus::inline scheduling
