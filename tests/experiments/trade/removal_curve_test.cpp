// What work can remove of visible error: the bound in hindsight against all choices, and orders.
// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/removal_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/numerics/random_stream.hpp"
#include "experiments/trade/estimate.hpp"

namespace impetus::removal_curve_test {

constexpr double kRounding = 1e-9;

/// Pairs of up to four levels; now and then a level is worse than the one before.
std::vector<PairLevels> random_pairs(RandomStream& random, std::size_t count) {
  std::vector<PairLevels> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    PairLevels pair{{0, static_cast<std::int32_t>(i + 1)}, {{0, {10.0 * random.uniform(), 1.0}}}};
    const std::uint64_t levels = 1 + random.below(3);
    for (std::uint64_t level = 0; level < levels; ++level) {
      const PairAtLevel& before = pair.levels.back();
      const auto work = before.work + 1 + static_cast<std::int64_t>(random.below(9));
      pair.levels.push_back({work, {1.1 * before.left.gap * random.uniform(), 1.0}});
    }
    pairs.push_back(pair);
  }
  return pairs;
}

/// The most that any choice of levels removes within `work`, by trying all.
double most_removed(const std::vector<PairLevels>& pairs, std::size_t from, std::int64_t work) {
  if (from == pairs.size()) {
    return 0.0;
  }
  double most = 0.0;
  const PairLevels& pair = pairs[from];
  for (const PairAtLevel& level : pair.levels) {
    if (level.work <= work) {
      most = std::max(most, pair.levels.front().left.gap - level.left.gap +
                                most_removed(pairs, from + 1, work - level.work));
    }
  }
  return most;
}

TEST(RemovalCurve, HindsightIsNoLessThanTheBestOfAllChoicesAndCloseToIt) {
  RandomStream random(77, "knapsacks");
  double of_best = 0.0;
  double of_bound = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const std::vector<PairLevels> pairs = random_pairs(random, 6);
    const RemovalCurve bound = RemovalCurve::in_hindsight(pairs, &VisibleError::gap);
    for (std::int64_t work = 0; work <= 60; work += 3) {
      const double best = most_removed(pairs, 0, work);
      ASSERT_GE(bound.removed(work), best - kRounding) << "trial " << trial << ", work " << work;
      of_best += best;
      of_bound += bound.removed(work);
    }
  }
  EXPECT_GT(of_best, 0.9 * of_bound) << "a bound that is never near is none";
}

TEST(RemovalCurve, HindsightTakesWhatRemovesMostPerWorkFirst) {
  // 6 for 2, then 4 for 2, 1 for 4.
  const std::vector<PairLevels> pairs{{{0, 1}, {{0, {5.0, 0.0}}, {2, {1.0, 0.0}}, {6, {0.0, 0.0}}}},
                                      {{0, 2}, {{0, {6.0, 0.0}}, {2, {0.0, 0.0}}}}};
  const RemovalCurve curve = RemovalCurve::in_hindsight(pairs, &VisibleError::gap);
  EXPECT_DOUBLE_EQ(curve.removed(0), 0.0);
  EXPECT_DOUBLE_EQ(curve.removed(1), 3.0);
  EXPECT_DOUBLE_EQ(curve.removed(2), 6.0);
  EXPECT_DOUBLE_EQ(curve.removed(4), 10.0);
  EXPECT_DOUBLE_EQ(curve.removed(6), 10.5);
  EXPECT_DOUBLE_EQ(curve.removed(1'000), 11.0);
}

TEST(RemovalCurve, AnOrderCountsALevelWhenItIsComplete) {
  const std::vector<PairLevels> pairs{{{0, 1}, {{0, {5.0, 0.0}}, {2, {1.0, 0.0}}, {6, {0.0, 0.0}}}},
                                      {{0, 2}, {{0, {6.0, 0.0}}, {2, {0.0, 0.0}}}}};
  const RemovalCurve deep = RemovalCurve::depth_first(pairs, &VisibleError::gap, {0, 1});
  EXPECT_DOUBLE_EQ(deep.removed(1), 0.0);
  EXPECT_DOUBLE_EQ(deep.removed(2), 4.0);
  EXPECT_DOUBLE_EQ(deep.removed(7), 5.0);
  EXPECT_DOUBLE_EQ(deep.removed(8), 11.0);
  const RemovalCurve broad = RemovalCurve::breadth_first(pairs, &VisibleError::gap, {1, 0});
  EXPECT_DOUBLE_EQ(broad.removed(2), 6.0);
  EXPECT_DOUBLE_EQ(broad.removed(4), 10.0);
  EXPECT_DOUBLE_EQ(broad.removed(8), 11.0);
}

TEST(RemovalCurve, NoOrderBeatsHindsightAndAllEndAlikeWhereLevelsOnlyImprove) {
  RandomStream random(78, "orders");
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<PairLevels> pairs = random_pairs(random, 20);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      order.push_back(i);
    }
    random.shuffle(order);
    const RemovalCurve bound = RemovalCurve::in_hindsight(pairs, &VisibleError::gap);
    const RemovalCurve deep = RemovalCurve::depth_first(pairs, &VisibleError::gap, order);
    const RemovalCurve broad = RemovalCurve::breadth_first(pairs, &VisibleError::gap, order);
    for (std::int64_t work = 0; work < deep.work(); ++work) {
      ASSERT_GE(bound.removed(work), deep.removed(work) - kRounding);
      ASSERT_GE(bound.removed(work), broad.removed(work) - kRounding);
    }
    const double all =
        left_at_roots(pairs, &VisibleError::gap) - left_at_finest(pairs, &VisibleError::gap);
    EXPECT_NEAR(deep.removed(), all, kRounding);
    EXPECT_NEAR(broad.removed(), all, kRounding);
    EXPECT_EQ(deep.work(), broad.work());
  }
}

TEST(RatioOfSums, HoldsTheTrueRatioAsOftenAsItSays) {
  // Lower numbers uniform in [1, 2), upper ones 0.7 of them on average.
  RandomStream random(5, "ratios");
  constexpr int kTrials = 2'000;
  int held = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> over;
    std::vector<double> under;
    for (int i = 0; i < 20; ++i) {
      under.push_back(1.0 + random.uniform());
      over.push_back(under.back() * 1.4 * random.uniform());
    }
    const Estimate ratio = ratio_of_sums(over, under);
    held += ratio.low <= 0.7 && 0.7 <= ratio.high ? 1 : 0;
  }
  // 95 % and three standard errors of a share of 2,000: 1.5 %; a jackknife of 20 lacks up to 1 %.
  EXPECT_NEAR(static_cast<double>(held) / kTrials, 0.95, 0.025);
}

TEST(RatioOfSums, SaysNothingOfHowFewNumbersVaryNorOfNothingInAll) {
  EXPECT_DOUBLE_EQ(ratio_of_sums({1.0, 2.0}, {2.0, 4.0}).value, 0.5);
  EXPECT_TRUE(std::isnan(ratio_of_sums({1.0, 2.0}, {2.0, 4.0}).low));
  EXPECT_TRUE(std::isnan(ratio_of_sums({1.0}, {0.0}).value));
  const Estimate mean = ratio_of_sums({1.0, 3.0, 1.0, 3.0, 2.0}, {1.0, 1.0, 1.0, 1.0, 1.0});
  // s / √n = 1 / √5, t of four degrees of freedom 2.776 (the expansion: 2.77).
  EXPECT_NEAR(mean.high - mean.value, 2.776 / std::sqrt(5.0), 0.01);
}

}  // namespace impetus::removal_curve_test
