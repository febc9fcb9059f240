// SPDX-License-Identifier: MIT
#include "experiments/fitting/posterior_density.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/fitting/minimum.hpp"

namespace impetus::inline fitting {

using Eigen::Index;
using Eigen::VectorXd;

PosteriorDensity::PosteriorDensity(const ObserverKind& kind, const RatingParameters& assumed,
                                   const std::vector<AnsweringPerson>& people,
                                   const ObserverFit& fit)
    : likelihood_(kind, assumed, people, people.size() > 1) {
  constexpr double kSettled = 1e-4;
  std::vector<double> centre;
  std::vector<double> start;
  for (std::size_t i = 0; i < likelihood_.movable().size(); ++i) {
    const MovableParameter& one = likelihood_.movable()[i];
    const FittedParameter& found = *fit.find(one.name);
    if (found.held_because == kNotAsked) {
      likelihood_.forget_trait(one.name);
      continue;
    }
    free_.push_back(i);
    centre.push_back(one.on_scale(found.assumed));
    // A parameter that the fit left at an end of its scale would be far off in the prior's tail.
    const double reach = 2.0 * prior_sd(free_.size() - 1);
    start.push_back(
        std::clamp(one.on_scale(found.value), centre.back() - reach, centre.back() + reach));
  }
  centre_ = Eigen::Map<VectorXd>(centre.data(), static_cast<Index>(centre.size()));
  mode_ = Eigen::Map<VectorXd>(start.data(), static_cast<Index>(start.size()));
  const SmoothFunction cost = [this](const VectorXd& x) { return -logarithm(x); };
  if (!std::isfinite(cost(mode_))) {
    mode_ = centre_;
  }
  mode_ = find_minimum(cost, mode_, kSettled).at;
  covariance_ = inverse_of_curvature(curvature_at(cost, mode_));
}

const std::string& PosteriorDensity::name(std::size_t parameter) const {
  return movable(parameter).name;
}

double PosteriorDensity::value(std::size_t parameter, double x) const {
  return movable(parameter).from_scale(x);
}

double PosteriorDensity::prior_centre(std::size_t parameter) const {
  return centre_[static_cast<Index>(parameter)];
}

double PosteriorDensity::prior_sd(std::size_t parameter) const {
  switch (movable(parameter).scale) {
    case MovableParameter::Scale::kLog:
      return 1.0;  // 95 % within a factor of 7
    case MovableParameter::Scale::kShare:
      return 1.5;  // of .02: 95 % between .001 and .28
    default:
      return 3.0;  // 3 logits; of others: three quarters of what was assumed
  }
}

double PosteriorDensity::logarithm(const VectorXd& x) {
  double sum = 0.0;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    const MovableParameter& one = movable(i);
    const double at = x[static_cast<Index>(i)];
    if (!(std::abs(at) <= one.reach())) {
      return -std::numeric_limits<double>::infinity();
    }
    *one.place = one.from_scale(at);
    const double z = (at - prior_centre(i)) / prior_sd(i);
    sum -= 0.5 * z * z;
  }
  return sum + likelihood_.logarithm();
}

}  // namespace impetus::inline fitting
