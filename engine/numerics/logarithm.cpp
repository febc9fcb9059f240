// SPDX-License-Identifier: MIT
#include "engine/numerics/logarithm.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace impetus::inline numerics {
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

/// x = m · 2^twos, m in [√½, √2].
struct NearOne {
  double m{1.0};
  int twos{0};
};

NearOne near_one(double x) {
  NearOne parts;
  parts.m = std::frexp(x, &parts.twos);  // exact, in [½, 1)
  if (parts.m < 0.5 * std::numbers::sqrt2) {
    parts.m *= 2.0;
    --parts.twos;
  }
  return parts;
}

/// The logarithm of what is no positive finite number; none of others.
std::optional<double> log_of_the_odd(double x) {
  if (x == 0.0) {
    return -std::numeric_limits<double>::infinity();
  }
  if (!(x > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (x == std::numeric_limits<double>::infinity()) {
    return x;
  }
  return std::nullopt;
}

}  // namespace

double log10_of(double x) {
  if (const auto odd = log_of_the_odd(x)) {
    return *odd;
  }
  const auto [m, twos] = near_one(x);
  return (twos * std::numbers::ln2 + log_near_one(m)) * std::numbers::log10e;
}

double log_of(double x) {
  // ln 2 in two parts: the first has so few digits that its product with `twos` is exact.
  constexpr double kLn2Head = 0x1.62e42fee00000p-1;
  constexpr double kLn2Tail = 0x1.a39ef35793c76p-33;
  if (const auto odd = log_of_the_odd(x)) {
    return *odd;
  }
  const auto [m, twos] = near_one(x);
  return twos * kLn2Head + (twos * kLn2Tail + log_near_one(m));
}

}  // namespace impetus::inline numerics
