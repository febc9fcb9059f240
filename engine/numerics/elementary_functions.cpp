// SPDX-License-Identifier: MIT
#include "engine/numerics/elementary_functions.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace impetus::inline numerics {
namespace {

/// Taylor series on |x| ≤ π/4 radians, where the first term left out is below 1e-18.
SineCosine on_first_octant(double x) {
  const double square = x * x;
  double sine = 0.0;
  double cosine = 0.0;
  for (int term = 9; term >= 1; --term) {
    sine = -square / ((2.0 * term) * (2.0 * term + 1.0)) * (1.0 + sine);
    cosine = -square / ((2.0 * term - 1.0) * (2.0 * term)) * (1.0 + cosine);
  }
  return {x * (1.0 + sine), 1.0 + cosine};
}

/// atan(x) for x in [0, 1]: atan(x) = atan(k/8) + atan(t), t = (x − k/8) / (1 + x k/8), with k/8
/// the eighth nearest to x, so |t| ≤ 1/16 and the first term of the series left out is below 1e-21.
double atan_on_unit(double x) {
  constexpr double kAtanOfEighths[] = {0x0.0p+0,
                                       0x1.fd5ba9aac2f6ep-4,
                                       0x1.f5b75f92c80ddp-3,
                                       0x1.6f61941e4def1p-2,
                                       0x1.dac670561bb4fp-2,
                                       0x1.1e00babdefeb4p-1,
                                       0x1.4978fa3269ee1p-1,
                                       0x1.700a7c5784634p-1,
                                       0x1.921fb54442d18p-1};
  const int eighths = static_cast<int>(std::floor(8.0 * x + 0.5));
  const double nearest = eighths / 8.0;
  const double rest = (x - nearest) / (1.0 + x * nearest);
  const double square = rest * rest;
  double series = 0.0;
  for (int power = 17; power >= 3; power -= 2) {
    series = square * (1.0 / power - series);
  }
  return kAtanOfEighths[eighths] + rest * (1.0 - series);
}

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

/// exp(−z²/2) / √(2π). z² is split so that its rounding is not magnified by the exponential.
double density(double z) {
  const double head = std::floor(z * 16.0) / 16.0;
  const double rest = (z - head) * (z + head);
  return exp_of(-0.5 * head * head) * exp_of(-0.5 * rest) * std::numbers::inv_sqrtpi /
         std::numbers::sqrt2;
}

/// Φ(z) − ½ = φ(z) (z + z³/3 + z⁵/(3·5) + …) for z ≥ 0: all terms positive (Marsaglia 2004).
double above_the_middle(double z) {
  double term = z;
  double sum = z;
  for (double odd = 3.0; term > 1e-18 * sum; odd += 2.0) {
    term *= z * z / odd;
    sum += term;
  }
  return density(z) * sum;
}

/// 1 − Φ(z) = φ(z) / (z + 1/(z + 2/(z + 3/(z + …)))) for z > 0 (Laplace), from the inside out.
double upper_tail(double z) {
  // What is left out after n terms is about exp(−2 z √n) of the whole.
  const int terms = 10 + static_cast<int>(360.0 / (z * z));
  double fraction = z;
  for (int term = terms; term >= 1; --term) {
    fraction = z + term / fraction;
  }
  return density(z) / fraction;
}

}  // namespace

SineCosine sine_cosine_deg(double angle_deg) {
  // floor and the subtraction are exact in binary for these sizes, hence the same everywhere.
  const double quarter_turns = std::floor(angle_deg / 90.0 + 0.5);
  const double rest_deg = angle_deg - 90.0 * quarter_turns;
  const SineCosine base = on_first_octant(rest_deg * (std::numbers::pi / 180.0));
  switch (static_cast<long long>(quarter_turns) & 3) {
    case 0:
      return base;
    case 1:
      return {base.cosine, -base.sine};
    case 2:
      return {-base.sine, -base.cosine};
    default:
      return {-base.cosine, base.sine};
  }
}

double atan2_rad(double y, double x) {
  const double width = x < 0.0 ? -x : x;
  const double height = y < 0.0 ? -y : y;
  if (width == 0.0 && height == 0.0) {
    return 0.0;
  }
  const double ratio = height <= width ? height / width : width / height;
  if (!(ratio <= 1.0)) {
    return ratio;  // not a number: no index into the table
  }
  double angle =
      height <= width ? atan_on_unit(ratio) : 0.5 * std::numbers::pi - atan_on_unit(ratio);
  angle = x < 0.0 ? std::numbers::pi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

double degrees(double angle_rad) { return angle_rad * (180.0 / std::numbers::pi); }

double metres_per_degree(double viewing_distance_m) {
  const SineCosine half = sine_cosine_deg(0.5);
  return 2.0 * viewing_distance_m * (half.sine / half.cosine);
}

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

double cube_root(double x) {
  // From above, the iteration falls until rounding stops it.
  double root = x > 1.0 ? x : 1.0;
  while (true) {
    const double next = (2.0 * root + x / (root * root)) / 3.0;
    if (!(next < root)) {
      return root;
    }
    root = next;
  }
}

double cumulative_normal(double z) {
  constexpr double kTail = 1.0;
  constexpr double kEnd = 40.0;  // where doubles end, too
  if (std::isnan(z)) {
    return z;
  }
  if (std::abs(z) >= kEnd) {
    return z > 0.0 ? 1.0 : 0.0;
  }
  if (z >= kTail) {
    return 1.0 - upper_tail(z);
  }
  if (z <= -kTail) {
    return upper_tail(-z);
  }
  return z >= 0.0 ? 0.5 + above_the_middle(z) : 0.5 - above_the_middle(-z);
}

}  // namespace impetus::inline numerics
