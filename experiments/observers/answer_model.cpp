// SPDX-License-Identifier: MIT
#include "experiments/observers/answer_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/observers/draws.hpp"
#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {
namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// What is rounded to a mark; at an end of the line, all beyond it too.
struct RoundedTo {
  double from;
  double to;
};

RoundedTo rounded_to(const Mark& mark) {
  constexpr double kBeyond = std::numeric_limits<double>::infinity();
  RoundedTo range{mark.value - 0.5 * mark.grain, mark.value + 0.5 * mark.grain};
  if (range.from < mark.least) {
    range.from = -kBeyond;
  }
  if (range.to > mark.most) {
    range.to = kBeyond;
  }
  return range;
}

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

double mark_chance(const Mark& mark, double meant, double sd) {
  constexpr double kLeastSd = 1e-6;
  const RoundedTo rounded = rounded_to(mark);
  const double unit = mark.value > meant ? -std::max(sd, kLeastSd) : std::max(sd, kLeastSd);
  return std::abs(normal_cdf((rounded.to - meant) / unit) -  // in the lower tail, where it is exact
                  normal_cdf((rounded.from - meant) / unit));
}

double mark_chance_anywhere(const Mark& mark) {
  const RoundedTo rounded = rounded_to(mark);
  return (std::min(rounded.to, mark.most) - std::max(rounded.from, mark.least)) /
         (mark.most - mark.least);
}

}  // namespace impetus::inline observers
