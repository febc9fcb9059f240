// SPDX-License-Identifier: MIT
#include "experiments/observers/rating_observer.hpp"

#include <cmath>
#include <numbers>

namespace impetus {
namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

}  // namespace

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double RatingObserver::normal() {
  // Box and Muller 1958. An observer may use the library's functions: its answers are recorded.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - stream_.uniform()));
  const double angle = 2.0 * std::numbers::pi * stream_.uniform();
  return radius * std::cos(angle);
}

void RatingObserver::draw_traits() {
  intercept_ = parameters_.intercept_sd * normal();
  if (parameters_.effect_sd > 0.0) {
    slope_ = parameters_.effect_sd * normal();
  }
}

std::array<double, 3> RatingObserver::probabilities(double seen) const {
  const double disbelief = parameters_.baseline + (parameters_.effect + slope_) * seen + intercept_;
  const double at_most_1 = logistic(parameters_.cut_1_2 - disbelief);
  const double at_most_2 = logistic(parameters_.cut_2_3 - disbelief);
  std::array<double, 3> probabilities{at_most_1, at_most_2 - at_most_1, 1.0 - at_most_2};
  for (double& probability : probabilities) {
    probability = (1.0 - parameters_.lapse_rate) * probability + parameters_.lapse_rate / 3.0;
  }
  return probabilities;
}

Answer RatingObserver::ask(const Page& page) {
  Answer answer;
  answer.device = "simulated";
  answer.shown_ns = clock_->now_ns();
  answer.fields.assign(page.fields.size(), "");
  double reaction_ms = parameters_.reaction_median_ms;
  if (page.layout == Page::Layout::kScale) {
    const auto chances = probabilities(seen_);
    const double draw = stream_.uniform();
    answer.choice = draw < chances[0] ? 0 : draw < chances[0] + chances[1] ? 1 : 2;
    reaction_ms *= std::exp(parameters_.reaction_sigma_log * normal());
  }
  clock_->advance_by(std::llround(reaction_ms * 1e6));
  answer.arrived_ns = clock_->now_ns();
  return answer;
}

}  // namespace impetus
