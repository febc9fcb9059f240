// The metrics by name.
//
//   distance       metres from the eye to the midpoint of the centres        near first
//   size           degrees that the two bounds' diameters span, mean         large first
//   velocity       degrees per second of the two bodies, mean                slow first
//   eccentricity   degrees between the collision's place and the fixation    central first
//   projected-gap  degrees that the trees' fit error spans there             large first
//
// (Dingliana 2002, sec. 5.2.1; eq. 5.1, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus {

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
  std::optional<ScreenPoint> point{};  ///< eccentricity: from here, wherever the viewer looks
  std::vector<WeightedTerm> terms{};   ///< of a weighted sum
};

/// The metric called `name`. Throws std::invalid_argument that lists the names there are, or says
/// what is wrong with the options.
std::shared_ptr<const PriorityMetric> make_metric(std::string_view name,
                                                  const MetricOptions& options = {});

/// The names make_metric() takes, in alphabetical order.
std::vector<std::string_view> metric_names();

}  // namespace impetus
