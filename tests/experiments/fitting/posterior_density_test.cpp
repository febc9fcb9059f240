// How probable parameters are in the light of answers and of what was assumed.
// SPDX-License-Identifier: MIT
#include "experiments/fitting/posterior_density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::posterior_density_test {

/// One person, a hundred yes or no to delays; nobody rated anything.
struct Answered {
  ObserverFile file{shipped_observer("causality-thresholds")};
  std::vector<AnsweringPerson> people{answering_group(file, delays_study(10), 1, /*seed=*/3)};
  ObserverFit fit{fit_observer(*file.kind, *file.parameters, people, {.as_group = false})};
  PosteriorDensity density{*file.kind, *file.parameters, people, fit};

  [[nodiscard]] std::size_t place(const std::string& name) const {
    std::size_t at = 0;
    while (at < density.size() && density.name(at) != name) {
      ++at;
    }
    return at;
  }
};

// log P(yes to a delay) = log(guess + (1 - guess - miss) Φ((delay - threshold) / width)), and the
// normal priors, written out again.
TEST(PosteriorDensity, IsTheLikelihoodTimesThePriors) {
  Answered one;
  Eigen::VectorXd x(static_cast<Eigen::Index>(one.density.size()));
  double priors = 0.0;
  for (std::size_t i = 0; i < one.density.size(); ++i) {
    const double z = 0.1 * static_cast<double>(i + 1);
    x[static_cast<Eigen::Index>(i)] = one.density.prior_centre(i) + z * one.density.prior_sd(i);
    priors -= 0.5 * z * z;
  }
  const auto value = [&](const std::string& name) {
    const std::size_t at = one.place(name);
    return one.density.value(at, x[static_cast<Eigen::Index>(at)]);
  };
  double answers = 0.0;
  for (const AnsweredTrial& trial : one.people.front().trials) {
    const double z =
        (trial.percepts[0][0] - value("threshold_mean_ms")) / value("threshold_width_ms");
    const double seen = 0.5 * std::erfc(-z / std::sqrt(2.0));
    const double guess = value("guess_rate");
    const double yes = guess + (1.0 - guess - value("miss_rate")) * seen;
    answers += std::log(*trial.yes ? yes : 1.0 - yes);
  }
  EXPECT_NEAR(one.density.logarithm(x), answers + priors, 1e-9);
}

TEST(PosteriorDensity, WhatNoAnswerDependsOnIsNoPartOfIt) {
  const Answered one;
  EXPECT_LT(one.place("threshold_mean_ms"), one.density.size());
  for (const char* name : {"effect", "cut_1_2", "lapse_rate", "threshold_sd_ms"}) {
    EXPECT_EQ(one.place(name), one.density.size()) << name;
  }
}

TEST(PosteriorDensity, IsHighestNearWhatWasFitted) {
  Answered one;
  const std::size_t at = one.place("threshold_mean_ms");
  const double mode = one.density.value(at, one.density.mode()[static_cast<Eigen::Index>(at)]);
  const FittedParameter& fitted = *one.fit.find("threshold_mean_ms");
  EXPECT_GT(mode, fitted.low);
  EXPECT_LT(mode, fitted.high);
  EXPECT_GT(one.density.covariance().diagonal().minCoeff(), 0.0);
}

TEST(PosteriorDensity, IsNothingBeyondTheScalesEnds) {
  Answered one;
  Eigen::VectorXd x = one.density.mode();
  x[0] = 1000.0;
  EXPECT_EQ(one.density.logarithm(x), -std::numeric_limits<double>::infinity());
}

}  // namespace impetus::posterior_density_test
