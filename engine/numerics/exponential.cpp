// SPDX-License-Identifier: MIT
#include "engine/numerics/exponential.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace impetus::inline numerics {

double exp_of(double x) {
  constexpr double kMostFinite = 709.8;
  constexpr double kLeastPositive = -745.2;
  // ln 2 in two parts: the first has so few digits that its product with `twos` is exact.
  constexpr double kLn2Head = 0x1.62e42fee00000p-1;
  constexpr double kLn2Tail = 0x1.a39ef35793c76p-33;
  if (std::isnan(x)) {
    return x;
  }
  if (x > kMostFinite) {
    return std::numeric_limits<double>::infinity();
  }
  if (x < kLeastPositive) {
    return 0.0;
  }
  // x = twos · ln 2 + r, |r| ≤ 0.35: of the series, the first term left out is below 1e-17.
  const double twos = std::floor(x * std::numbers::log2e + 0.5);
  const double r = (x - twos * kLn2Head) - twos * kLn2Tail;
  double series = 1.0;
  for (int term = 14; term >= 2; --term) {
    series = 1.0 + r / term * series;
  }
  return std::ldexp(1.0 + r * series, static_cast<int>(twos));
}

}  // namespace impetus::inline numerics
