// SPDX-License-Identifier: MIT
#include "experiments/observers/draws.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace impetus::inline observers {

double draw_normal(RandomStream& stream) {
  // Box and Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - stream.uniform()));
  const double angle = 2.0 * std::numbers::pi * stream.uniform();
  return radius * std::cos(angle);
}

double draw_between(RandomStream& stream, double least, double most) {
  return least + (most - least) * stream.uniform();
}

double draw_lognormal(RandomStream& stream, double median, double sigma_log) {
  return median * std::exp(sigma_log * draw_normal(stream));
}

double draw_waiting(RandomStream& stream, double rate) {
  return rate > 0.0 ? -std::log(1.0 - stream.uniform()) / rate
                    : std::numeric_limits<double>::infinity();
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace impetus::inline observers
