// SPDX-License-Identifier: MIT
#include "experiments/trade/ratio_of_sums.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace impetus::inline trade {
namespace {

/// The 97.5 % quantile of Student's distribution, to half a per cent from three degrees of freedom
/// on, and too large below. (Cornish and Fisher's expansion: Abramowitz and Stegun, 26.7.5)
double student_quantile(double freedom) {
  constexpr double kZ = 1.959963985;
  constexpr double kZ3 = kZ * kZ * kZ;
  constexpr double kZ5 = kZ3 * kZ * kZ;
  constexpr double kZ7 = kZ5 * kZ * kZ;
  const double first = (kZ3 + kZ) / 4.0;
  const double second = (5.0 * kZ5 + 16.0 * kZ3 + 3.0 * kZ) / 96.0;
  const double third = (3.0 * kZ7 + 19.0 * kZ5 + 17.0 * kZ3 - 15.0 * kZ) / 384.0;
  return kZ + first / freedom + second / (freedom * freedom) +
         third / (freedom * freedom * freedom);
}

}  // namespace

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
  const double half = student_quantile(n - 1.0) * std::sqrt((n - 1.0) / n * squares);
  ratio.low = ratio.value - half;
  ratio.high = ratio.value + half;
  return ratio;
}

}  // namespace impetus::inline trade
