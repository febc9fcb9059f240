// SPDX-License-Identifier: MIT
#include "experiments/observers/rating_observer.hpp"

#include <cmath>

namespace impetus {
namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

}  // namespace

void RatingObserver::draw_traits() {
  intercept_ = parameters_.intercept_sd * normal();
  if (parameters_.effect_sd > 0.0) {
    slope_ = parameters_.effect_sd * normal();
  }
}

std::vector<double> RatingObserver::probabilities(double seen) const {
  const double eta = parameters_.baseline + (parameters_.effect + slope_) * seen + intercept_;
  std::vector<double> probabilities;
  double below = 0.0;
  for (const double cut : parameters_.cuts) {
    const double at_most = logistic(cut - eta);
    probabilities.push_back(at_most - below);
    below = at_most;
  }
  probabilities.push_back(1.0 - below);
  const double lapse = parameters_.lapse_rate;
  for (double& probability : probabilities) {
    probability = (1.0 - lapse) * probability + lapse / static_cast<double>(probabilities.size());
  }
  return probabilities;
}

std::size_t RatingObserver::draw_disbelief() {
  const std::vector<double> chances = probabilities(seen_);
  const double draw = stream_.uniform();
  double reached = 0.0;
  for (std::size_t point = 0; point + 1 < chances.size(); ++point) {
    reached += chances[point];
    if (draw < reached) {
      return point;
    }
  }
  return chances.size() - 1;
}

Answer RatingObserver::ask(const Page& page) {
  Answer answer;
  answer.device = "simulated";
  answer.shown_ns = clock_->now_ns();
  answer.fields.assign(page.fields.size(), "");
  double reaction_ms = parameters_.reaction_median_ms;
  if (page.layout == Page::Layout::kScale) {
    const std::size_t disbelief = draw_disbelief();
    answer.choice = page.best_choice == 0 ? disbelief : page.best_choice - disbelief;
    reaction_ms = draw_lognormal(stream_, reaction_ms, parameters_.reaction_sigma_log);
  }
  clock_->advance_by(std::llround(reaction_ms * 1e6));
  answer.arrived_ns = clock_->now_ns();
  return answer;
}

}  // namespace impetus
