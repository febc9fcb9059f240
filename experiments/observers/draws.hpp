// Random draws of the shapes that observers need, from a named stream.
//
// An observer may use the library's functions: what it answers is recorded, not computed again.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline observers {

/// Mean 0, standard deviation 1.
inline double draw_normal(RandomStream& stream) {
  // Box and Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - stream.uniform()));
  const double angle = 2.0 * std::numbers::pi * stream.uniform();
  return radius * std::cos(angle);
}

/// Uniform in [least, most).
inline double draw_between(RandomStream& stream, double least, double most) {
  return least + (most - least) * stream.uniform();
}

/// Lognormal: `sigma_log` is the standard deviation of the natural logarithm.
inline double draw_lognormal(RandomStream& stream, double median, double sigma_log) {
  return median * std::exp(sigma_log * draw_normal(stream));
}

/// Waiting time of a Poisson process (the rate's inverse unit); infinite at rate 0.
inline double draw_waiting(RandomStream& stream, double rate) {
  return rate > 0.0 ? -std::log(1.0 - stream.uniform()) / rate
                    : std::numeric_limits<double>::infinity();
}

/// Φ, the standard normal distribution function.
inline double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace impetus::inline observers
