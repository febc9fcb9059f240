// SPDX-License-Identifier: MIT
#include "engine/scheduling/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "engine/scheduling/named_kinds.hpp"
#include "engine/scheduling/perceived_metric.hpp"
#include "engine/scheduling/speed_metrics.hpp"
#include "engine/scheduling/visible_frequency.hpp"
#include "engine/scheduling/weighted_metric.hpp"

namespace impetus::inline scheduling {
namespace {

/// Metres from the eye to the midpoint of the centres: near collisions first. (Dingliana 2002,
/// sec. 5.2.1)
class DistanceMetric final : public PriorityMetric {
 public:
  DistanceMetric() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return (0.5 * (bounds.a.centre + bounds.b.centre) - viewer.eye).norm();
  }
};

/// Degrees that the two bounds' diameters span at the eye, mean: large bodies first. (Dingliana
/// 2002, sec. 5.2.1)
class SizeMetric final : public PriorityMetric {
 public:
  SizeMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return 0.5 * (spanned_deg(bounds.a, viewer) + spanned_deg(bounds.b, viewer));
  }

 private:
  /// The angle between opposite tangents from the eye: 2 asin(R / d).
  static double spanned_deg(const Sphere& sphere, const Viewer& viewer) {
    const double square = (sphere.centre - viewer.eye).squaredNorm();
    const double tangent_square = square - sphere.radius_m * sphere.radius_m;
    return tangent_square > 0.0
               ? degrees(2.0 * atan2_rad(sphere.radius_m, std::sqrt(tangent_square)))
               : 180.0;
  }
};

using Metric = std::shared_ptr<const PriorityMetric>;

/// What a metric is made of beside its name, as its constructor says.
template <typename T>
constexpr bool kTakesPoint = std::is_constructible_v<T, std::optional<ScreenPoint>>;
template <typename T>
constexpr bool kNotices = std::is_constructible_v<T, const Noticing&, std::optional<ScreenPoint>>;
template <typename T>
constexpr bool kTakesOptions = std::is_constructible_v<T, const MetricOptions&>;

template <typename T>
Metric made(const MetricOptions& options) {
  if constexpr (kTakesOptions<T>) {
    return std::make_shared<const T>(options);
  } else if constexpr (kNotices<T>) {
    return std::make_shared<const T>(options.noticing, options.point);
  } else if constexpr (kTakesPoint<T>) {
    return std::make_shared<const T>(options.point);
  } else {
    return std::make_shared<const T>();
  }
}

/// A metric by its name, what it measures, and how one is made.
struct NamedMetric {
  std::string_view name;
  std::string_view words;
  MeasureRange range;
  Metric (*make)(const MetricOptions&);
  bool takes_point;
  bool takes_terms;
};

template <typename T>
constexpr NamedMetric named(std::string_view name, std::string_view words, MeasureRange range) {
  constexpr bool kHasPoint = kTakesPoint<T> || kNotices<T> || kTakesOptions<T>;
  return {name, words, range, made<T>, kHasPoint, kTakesOptions<T>};
}

/// In alphabetical order. A new metric is one row here.
constexpr NamedMetric kMetrics[] = {
    named<CollisionSpeedMetric>("collision-speed",
                                "degrees per second of one body past the other, the slow",
                                {"°/s", 0.0, 60.0}),
    named<DistanceMetric>("distance", "m from the eye to the midpoint of the centres, the near",
                          {"m", 0.0, 2.0}),
    named<EccentricityMetric>(
        "eccentricity",
        "degrees between the collision's place and where the viewer looks, the central",
        {"°", 0.0, 30.0}),
    named<GapMetric>("gap", "m between the centres of the two bounds, the large", {"m", 0.2, 0.0}),
    named<GapBoundMetric>("gap-bound",
                          "m that the gap cannot exceed: the trees' fit error, the large",
                          {"m", 0.1, 0.0}),
    named<PerceivedMetric>("perceived",
                           "probability that the gap a pair may be left with is noticed, at its "
                           "speed and eccentricity, "
                           "the high",
                           {"", 1.0, 0.0}),
    named<ProjectedCentresMetric>("projected-centres",
                                  "degrees between the centres of the two bounds, the large",
                                  {"°", 15.0, 0.0}),
    named<ProjectedGapMetric>("projected-gap",
                              "degrees that the trees' fit error spans there, the large",
                              {"°", 15.0, 0.0}),
    named<SizeMetric>("size", "degrees that the two bounds' diameters span, mean, the large",
                      {"°", 15.0, 0.0}),
    named<VelocityMetric>("velocity", "degrees per second of the two bodies, mean, the slow",
                          {"°/s", 0.0, 60.0}),
    named<VisibleFrequencyMetric>("visible-frequency",
                                  "cycles per degree that can be seen there, the high",
                                  {"c/°", 60.0, 0.0}),
    named<WeightedMetric>("weighted", "sum of weights, of others brought to [0, 1], the high",
                          {"", 2.0, 0.0})};

const NamedMetric* found(std::string_view name) {
  const NamedMetric* metric =
      std::find_if(std::begin(kMetrics), std::end(kMetrics),
                   [name](const NamedMetric& each) { return each.name == name; });
  return metric == std::end(kMetrics) ? nullptr : metric;
}

bool is_above_zero(double number) { return number > 0.0 && std::isfinite(number); }

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
  if (options.point && !(std::isfinite(options.point->x_m) && std::isfinite(options.point->y_m))) {
    refuse("a point of finite numbers",
           std::to_string(options.point->x_m) + ", " + std::to_string(options.point->y_m) + " m");
  }
  const Noticing& noticing = options.noticing;
  if (!(is_above_zero(noticing.threshold_arcmin) && is_above_zero(noticing.width_log10) &&
        noticing.miss_rate >= 0.0 && noticing.miss_rate <= 1.0)) {
    refuse("a threshold and a width above 0, and a miss rate from 0 to 1",
           std::to_string(noticing.threshold_arcmin) + ", " + std::to_string(noticing.width_log10) +
               " and " + std::to_string(noticing.miss_rate));
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

MetricOptions options_for(std::string_view name, const MetricOptions& all) {
  MetricOptions options;
  if (takes_point(name)) {
    options.point = all.point;
  }
  if (needs_terms(name)) {
    options.terms = all.terms;
  }
  options.noticing = all.noticing;
  return options;
}

std::vector<std::string_view> metric_names() {
  std::vector<std::string_view> names;
  for (const NamedMetric& metric : kMetrics) {
    names.push_back(metric.name);
  }
  return names;
}

std::string metrics_in_words() {
  std::string words;
  for (const NamedMetric& metric : kMetrics) {
    words += words.empty() ? "" : " ";
    words += std::string(metric.name) + ": " + std::string(metric.words) + " first.";
  }
  return words;
}

MeasureRange measure_range(std::string_view name) {
  const NamedMetric* metric = found(name);
  return metric == nullptr ? MeasureRange{} : metric->range;
}

}  // namespace impetus::inline scheduling
