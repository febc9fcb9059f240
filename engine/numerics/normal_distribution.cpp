// SPDX-License-Identifier: MIT
#include "engine/numerics/normal_distribution.hpp"

#include <cmath>
#include <numbers>

#include "engine/numerics/exponential.hpp"

namespace impetus::inline numerics {
namespace {

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
