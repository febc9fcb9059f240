// SPDX-License-Identifier: MIT
#include "engine/numerics/logarithm.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace impetus {
namespace {

/// ln m = 2 artanh s, s = (m − 1) / (m + 1), for m in [√½, √2]: |s| ≤ 0.172, so the first term of
/// the series left out is below 1e-18 of the first.
double log_near_one(double m) {
  const double s = (m - 1.0) / (m + 1.0);
  const double square = s * s;
  double series = 0.0;
  for (int power = 21; power >= 3; power -= 2) {
    series = square * (1.0 / power + series);
  }
  return 2.0 * s * (1.0 + series);
}

}  // namespace

double log10_of(double x) {
  if (x == 0.0) {
    return -std::numeric_limits<double>::infinity();
  }
  if (!(x > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (x == std::numeric_limits<double>::infinity()) {
    return x;
  }
  int twos = 0;
  double m = std::frexp(x, &twos);  // exact, in [½, 1)
  if (m < 0.5 * std::numbers::sqrt2) {
    m *= 2.0;
    --twos;
  }
  return (twos * std::numbers::ln2 + log_near_one(m)) * std::numbers::log10e;
}

}  // namespace impetus
