// SPDX-License-Identifier: MIT
#include "experiments/observers/answer_model.hpp"

#include <cmath>

#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {
namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

}  // namespace

double cumulative_rating(const RatingParameters& parameters, const Traits& traits, double seen,
                         std::size_t steps, std::size_t points) {
  const double slope = parameters.effect_sd * traits.slope;
  const double intercept = parameters.intercept_sd * traits.intercept;
  const double eta = parameters.baseline + (parameters.effect + slope) * seen + intercept;
  const double below = steps == 0 ? 0.0 : logistic(parameters.cuts[steps - 1] - eta);
  const double at_most = steps + 1 == points ? 1.0 : logistic(parameters.cuts[steps] - eta);
  const double lapse = parameters.lapse_rate;
  return (1.0 - lapse) * (at_most - below) + lapse / static_cast<double>(points);
}

double yes_chance(const RatingParameters& parameters, double seen) {
  const double guess = parameters.yes_guess_rate;
  return guess + (1.0 - guess - parameters.yes_miss_rate) * seen;
}

double first_chance(const RatingParameters& parameters, double seen_first, double seen_second) {
  return 0.5 + 0.5 * (1.0 - parameters.lapse_rate) * (seen_first - seen_second);
}

}  // namespace impetus::inline observers
