// SPDX-License-Identifier: MIT
#include "experiments/observers/causality_observer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace impetus {
namespace {

double logistic(double x) { return 1.0 / (1.0 + std::exp(-x)); }

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

}  // namespace

CausalityObserver::CausalityObserver(const CausalityParameters& parameters, std::uint64_t seed,
                                     const std::string& pseudonym, VirtualClock& clock)
    : parameters_(parameters),
      clock_(&clock),
      stream_(seed, "observer/causality/" + pseudonym),
      threshold_ms_(parameters.threshold_mean_ms),
      intercept_(0.0) {
  threshold_ms_ += parameters.threshold_sd_ms * normal();
  intercept_ += parameters.intercept_sd * normal();
}

double CausalityObserver::normal() {
  // Box and Muller 1958. An observer may use the library's functions: its answers are recorded.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - stream_.uniform()));
  const double angle = 2.0 * std::numbers::pi * stream_.uniform();
  return radius * std::cos(angle);
}

void CausalityObserver::witnessed(const AttemptRecord& shown) {
  witnessed_delay_ms_ = 0.0;
  for (const CollisionRecord& collision : shown.collisions) {
    witnessed_delay_ms_ = std::max(witnessed_delay_ms_, 1e3 * collision.report.imposed_hold_s);
  }
}

std::array<double, 3> CausalityObserver::rating_probabilities(double delay_ms) const {
  const double seen = normal_cdf((delay_ms - threshold_ms_) / parameters_.threshold_width_ms);
  const double disbelief = parameters_.baseline + parameters_.delay_effect * seen + intercept_;
  const double at_most_1 = logistic(parameters_.cuts[0] - disbelief);
  const double at_most_2 = logistic(parameters_.cuts[1] - disbelief);
  std::array<double, 3> probabilities{at_most_1, at_most_2 - at_most_1, 1.0 - at_most_2};
  for (double& probability : probabilities) {
    probability = (1.0 - parameters_.lapse_rate) * probability + parameters_.lapse_rate / 3.0;
  }
  return probabilities;
}

Answer CausalityObserver::ask(const Page& page) {
  Answer answer;
  answer.device = "simulated";
  answer.shown_ns = clock_->now_ns();
  answer.fields.assign(page.fields.size(), "");
  double reaction_ms = parameters_.reaction_median_ms;
  if (page.layout == Page::Layout::kScale) {
    const auto probabilities = rating_probabilities(witnessed_delay_ms_);
    const double draw = stream_.uniform();
    answer.choice = draw < probabilities[0]                      ? 0
                    : draw < probabilities[0] + probabilities[1] ? 1
                                                                 : 2;
    reaction_ms *= std::exp(parameters_.reaction_sigma_log * normal());
  }
  clock_->advance_by(std::llround(reaction_ms * 1e6));
  answer.arrived_ns = clock_->now_ns();
  return answer;
}

}  // namespace impetus
