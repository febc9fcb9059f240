// SPDX-License-Identifier: MIT
#include "experiments/trade/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "experiments/tables/student_t.hpp"

namespace impetus::inline trade {
Estimate ratio_of_sums(const std::vector<double>& over, const std::vector<double>& under) {
  constexpr std::size_t kFewest = 4;
  const double above = std::accumulate(over.begin(), over.end(), 0.0);
  const double below = std::accumulate(under.begin(), under.end(), 0.0);
  Estimate ratio;
  ratio.n = static_cast<std::int64_t>(over.size());
  if (below == 0.0) {
    return ratio;
  }
  ratio.value = above / below;
  if (over.size() < kFewest) {
    return ratio;
  }
  const auto n = static_cast<double>(over.size());
  std::vector<double> without;
  for (std::size_t i = 0; i < over.size(); ++i) {
    if (below == under[i]) {
      return ratio;  // one alone carries the ratio: nothing tells how it varies
    }
    without.push_back((above - over[i]) / (below - under[i]));
  }
  const double mean = std::accumulate(without.begin(), without.end(), 0.0) / n;
  double squares = 0.0;
  for (const double each : without) {
    squares += (each - mean) * (each - mean);
  }
  const double half = student_t(n - 1.0) * std::sqrt((n - 1.0) / n * squares);
  ratio.low = ratio.value - half;
  ratio.high = ratio.value + half;
  return ratio;
}

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

Estimate mean_over(const std::vector<double>& values) {
  return ratio_of_sums(values, std::vector<double>(values.size(), 1.0));
}

}  // namespace impetus::inline trade
