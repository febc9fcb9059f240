// What a list of measured values looks like: its middle, its tail, its spread.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace impetus::inline timing {

/// In the unit of the values; all zero without any.
struct Distribution {
  std::int64_t count{0};
  double mean{0.0};
  double sd{0.0};  ///< of the sample; 0 with fewer than two values
  double median{0.0};
  double p95{0.0};
  double p99{0.0};
  double largest{0.0};
};

/// Percentiles by nearest rank: the least value that so large a share does not exceed.
Distribution distribution_of(std::vector<double> values);

/// The share of the values that are above the limit; 0 without values.
double share_above(const std::vector<double>& values, double limit);

}  // namespace impetus::inline timing
