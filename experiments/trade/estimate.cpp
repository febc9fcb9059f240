// SPDX-License-Identifier: MIT
#include "experiments/trade/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace impetus::inline trade {
namespace {

constexpr double kTail = 0.025;

/// P(X = k), X binomial (n, p) with p in (0, 1).
double exactly(std::int64_t k, std::int64_t n, double p) {
  const auto of = static_cast<double>(n);
  const auto hits = static_cast<double>(k);
  return std::exp(std::lgamma(of + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(of - hits + 1.0) +
                  hits * std::log(p) + (of - hits) * std::log1p(-p));
}

/// P(X ≤ k).
double at_most(std::int64_t k, std::int64_t n, double p) {
  double sum = 0.0;
  for (std::int64_t i = 0; i <= k; ++i) {
    sum += exactly(i, n, p);
  }
  return sum;
}

/// The p in (0, 1) at which the falling P(X ≤ k) is `probability`.
double share_with(std::int64_t k, std::int64_t n, double probability) {
  double low = 0.0;
  double high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (at_most(k, n, middle) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Estimate quantile_of(std::vector<double> values, double p) {
  Estimate found;
  found.n = static_cast<std::int64_t>(values.size());
  if (values.empty()) {
    return found;
  }
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::int64_t>(std::ceil(p * static_cast<double>(found.n) - 1e-9));
  found.value = values[static_cast<std::size_t>(std::clamp<std::int64_t>(rank, 1, found.n) - 1)];
  double at_most_i = 0.0;  // P(at most i values lie below the quantile)
  for (std::int64_t i = 0; i < found.n && std::isnan(found.high); ++i) {
    at_most_i += exactly(i, found.n, p);
    if (at_most_i <= kTail) {
      found.low = values[static_cast<std::size_t>(i)];
    } else if (at_most_i >= 1.0 - kTail) {
      found.high = values[static_cast<std::size_t>(i)];
    }
  }
  return found;
}

Estimate mean_of(const std::vector<double>& values) {
  Estimate found;
  found.n = static_cast<std::int64_t>(values.size());
  if (!values.empty()) {
    found.value = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(found.n);
  }
  return found;
}

Estimate share_of(std::int64_t k, std::int64_t n) {
  Estimate found;
  found.n = n;
  if (n > 0) {
    found.value = static_cast<double>(k) / static_cast<double>(n);
    found.low = k == 0 ? 0.0 : share_with(k - 1, n, 1.0 - kTail);
    found.high = k == n ? 1.0 : share_with(k, n, kTail);
  }
  return found;
}

}  // namespace impetus::inline trade
