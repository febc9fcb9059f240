// Clicks explained: the densities of the model that participants draw from.
// SPDX-License-Identifier: MIT
#include "experiments/observers/explained_clicks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace impetus::explained_clicks_test {

constexpr ClickHabit kHabit{0.55, 0.25, 0.4, 0.0};

double lognormal_density(double waited_s) {
  const double z = std::log(waited_s / kHabit.median_s) / kHabit.sigma_log;
  return std::exp(-0.5 * z * z) / (waited_s * kHabit.sigma_log * std::sqrt(2.0 * 3.14159265358979));
}

double lognormal_share(double waited_s) {
  return 0.5 * std::erfc(-std::log(waited_s / kHabit.median_s) / kHabit.sigma_log / std::sqrt(2.0));
}

// log(p f(t)), and without a click log(1 − p F(T)).
TEST(ExplainedClicks, OfOneEventAreTheClosedForm) {
  std::vector<PossibleEvent> events{{1.0, 0.7}};
  EXPECT_NEAR(explain_clicks(kHabit, {1.6}, 10.0, events), std::log(0.7 * lognormal_density(0.6)),
              1e-9);
  EXPECT_NEAR(events[0].chance, 1.0, 1e-9);
  events = {{1.0, 0.7}};
  EXPECT_NEAR(explain_clicks(kHabit, {}, 1.5, events), std::log(1.0 - 0.7 * lognormal_share(0.5)),
              1e-9);
  // P(seen | silent) = p (1 − F) / (1 − p F)
  EXPECT_NEAR(events[0].chance,
              0.7 * (1.0 - lognormal_share(0.5)) / (1.0 - 0.7 * lognormal_share(0.5)), 1e-9);
}

// Of two of which one at most was seen: log(p f(t) + q g(t)), and log(1 − p F − q G).
TEST(ExplainedClicks, OfAlternativesAreTheClosedForm) {
  const std::vector<PossibleEvent> both{{1.0, 0.5}, {1.05, 0.3, true}};
  std::vector<PossibleEvent> events = both;
  const double first = 0.5 * lognormal_density(0.6);
  const double second = 0.3 * lognormal_density(0.55);
  EXPECT_NEAR(explain_clicks(kHabit, {1.6}, 10.0, events), std::log(first + second), 1e-9);
  EXPECT_NEAR(events[0].chance, first / (first + second), 1e-9);
  EXPECT_NEAR(events[1].chance, second / (first + second), 1e-9);
  events = both;
  const double silent = 1.0 - 0.5 * lognormal_share(0.5) - 0.3 * lognormal_share(0.45);
  EXPECT_NEAR(explain_clicks(kHabit, {}, 1.5, events), std::log(silent), 1e-9);
  EXPECT_NEAR(events[1].chance, 0.3 * (1.0 - lognormal_share(0.45)) / silent, 1e-9);
}

// Over all that one event and false clicks can do there is a probability of 1: none, or the first
// at t, in the time before another could be made.
TEST(ExplainedClicks, DensitiesOfNoneAndOfTheFirstAddUpToOne) {
  const ClickHabit habit{0.55, 0.25, 10.0, 0.3};
  constexpr double kStimulus_s = 2.0;
  constexpr double kStep_s = 1e-3;
  std::vector<PossibleEvent> events{{0.4, 0.6}};
  double sum = std::exp(explain_clicks(habit, {}, kStimulus_s, events));
  for (double at_s = 0.5 * kStep_s; at_s < kStimulus_s; at_s += kStep_s) {
    events = {{0.4, 0.6}};
    sum += kStep_s * std::exp(explain_clicks(habit, {at_s}, kStimulus_s, events));
  }
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

// Poisson: λⁿ exp(−λ T), less what the time after each click takes away.
TEST(ExplainedClicks, AtNothingArePoisson) {
  std::vector<PossibleEvent> none;
  const ClickHabit habit{0.55, 0.25, 0.4, 0.2};
  EXPECT_NEAR(explain_clicks(habit, {1.0, 5.0}, 10.0, none),
              2.0 * std::log(0.2) - 0.2 * (10.0 - 0.8), 1e-12);
}

TEST(ExplainedClicks, CountsOfEventsAreBinomialWhereChancesAreEqual) {
  const std::vector<double> chances = chances_of_count({{0.0, 0.3}, {1.0, 0.3}, {2.0, 0.3}});
  ASSERT_EQ(chances.size(), 4U);
  EXPECT_NEAR(chances[0], 0.343, 1e-12);
  EXPECT_NEAR(chances[1], 0.441, 1e-12);
  EXPECT_NEAR(chances[2], 0.189, 1e-12);
  EXPECT_NEAR(chances[3], 0.027, 1e-12);
}

TEST(ExplainedClicks, OfAlternativesOneCountsAtMost) {
  const std::vector<double> chances =
      chances_of_count({{0.0, 0.3}, {0.05, 0.2, true}, {0.08, 0.1, true}, {1.0, 0.5}});
  ASSERT_EQ(chances.size(), 3U);
  EXPECT_NEAR(chances[0], 0.2, 1e-12);
  EXPECT_NEAR(chances[1], 0.5, 1e-12);
  EXPECT_NEAR(chances[2], 0.3, 1e-12);
}

}  // namespace impetus::explained_clicks_test
