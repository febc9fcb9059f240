// SPDX-License-Identifier: MIT
#include "experiments/timing/distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace impetus::inline timing {
namespace {

double nearest_rank(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

double sample_sd(const std::vector<double>& values, double mean) {
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  const auto count = static_cast<double>(values.size());
  return count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
}

}  // namespace

Distribution distribution_of(std::vector<double> values) {
  if (values.empty()) {
    return {};
  }
  std::sort(values.begin(), values.end());
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return {static_cast<std::int64_t>(values.size()),
          mean,
          sample_sd(values, mean),
          nearest_rank(values, 0.50),
          nearest_rank(values, 0.95),
          nearest_rank(values, 0.99),
          values.back()};
}

double share_above(const std::vector<double>& values, double limit) {
  if (values.empty()) {
    return 0.0;
  }
  const auto above =
      std::count_if(values.begin(), values.end(), [limit](double value) { return value > limit; });
  return static_cast<double>(above) / static_cast<double>(values.size());
}

}  // namespace impetus::inline timing
