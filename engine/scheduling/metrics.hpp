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
#include <string_view>
#include <vector>

#include "engine/scheduling/priority.hpp"

namespace impetus {

/// The metric called `name`. Throws std::invalid_argument that lists the names there are.
std::shared_ptr<const PriorityMetric> make_metric(std::string_view name);

/// The names make_metric() takes, in alphabetical order.
std::vector<std::string_view> metric_names();

}  // namespace impetus
