// SPDX-License-Identifier: MIT
#include "experiments/observers/rating_observer.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline observers {
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

void RatingObserver::witnessed(const AttemptRecord& shown, const StagedScene& scene) {
  const bool second = !shown.frames.empty() && shown.frames.back().interval == 2;
  if (!second) {
    seen_.clear();
  }
  seen_.push_back(seen(shown, scene));
}

double RatingObserver::yes_probability(double seen) const {
  const double guess = parameters_.yes_guess_rate;
  return guess + (1.0 - guess - parameters_.yes_miss_rate) * seen;
}

double RatingObserver::first_probability(double seen_first, double seen_second) const {
  return 0.5 + 0.5 * (1.0 - parameters_.lapse_rate) * (seen_first - seen_second);
}

Answer RatingObserver::ask(const Page& page) {
  Answer answer;
  answer.device = "simulated";
  answer.shown_ns = clock_->now_ns();
  answer.fields.assign(page.fields.size(), "");
  double reaction_ms = parameters_.reaction_median_ms;
  const ResponseKind* kind = find_kind(page.response);
  if (kind != nullptr && kind->simulate != nullptr) {
    kind->simulate(page, *this, answer);
    reaction_ms = draw_lognormal(stream_, reaction_ms, parameters_.reaction_sigma_log);
  }
  if (page.timeout_ms > 0.0 && reaction_ms > page.timeout_ms) {
    answer.timed_out = true;
    answer.device = "none";
    answer.choice = 0;
    answer.fields.assign(page.fields.size(), "");
    reaction_ms = page.timeout_ms;
  }
  clock_->advance_by(std::llround(reaction_ms * 1e6));
  answer.arrived_ns = clock_->now_ns();
  return answer;
}

}  // namespace impetus::inline observers
