// Single precision that never says less than the double it came from.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace impetus::inline numerics {

/// The least float that is not below `x`.
inline float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  return static_cast<double>(nearest) < x
             ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
             : nearest;
}

}  // namespace impetus::inline numerics
