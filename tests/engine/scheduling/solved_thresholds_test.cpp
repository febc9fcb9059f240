// Shares of pairs: thresholds solved from a pilot, and ranks within a step.
// SPDX-License-Identifier: MIT
#include "engine/scheduling/solved_thresholds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/scheduling/metrics.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/scheduled_pairs.hpp"

namespace impetus::solved_thresholds_test {

constexpr std::uint64_t kSeed = 53;

/// How many of the measures fall into each list, counted by the rule "thresholds".
std::vector<std::size_t> counts(const std::vector<double>& thresholds,
                                const std::vector<double>& measures, const PriorityMetric& metric) {
  std::vector<std::size_t> counted(thresholds.size() + 1, 0);
  for (const double measure : measures) {
    std::size_t list = 0;
    while (list < thresholds.size() && !metric.meets(measure, thresholds[list])) {
      ++list;
    }
    ++counted[list];
  }
  return counted;
}

TEST(SolvedThresholds, GiveEachListItsShareOfDifferentMeasures) {
  RandomStream random(kSeed, "measures");
  for (const char* name : {"distance", "size"}) {  // small first, large first
    const auto metric = make_metric(name);
    for (int trial = 0; trial < 200; ++trial) {
      std::vector<double> measures(1 + random.below(500));
      for (double& measure : measures) {
        measure = uniform_in(random, -5.0, 20.0);
      }
      std::vector<double> shares;
      double left = 1.0;
      for (std::uint64_t list = random.below(15); list > 0; --list) {
        shares.push_back(left * random.uniform());
        left -= shares.back();
      }
      const std::vector<double> thresholds = thresholds_for(shares, measures, *metric);
      const std::vector<std::size_t> found = counts(thresholds, measures, *metric);
      double wanted = 0.0;
      std::size_t in_lists = 0;
      for (std::size_t list = 0; list < shares.size(); ++list) {
        wanted += shares[list] * static_cast<double>(measures.size());
        in_lists += found[list];
        // Half a pair is the nearest that whole pairs come.
        EXPECT_NEAR(static_cast<double>(in_lists), wanted, 0.5 + 1e-9) << name << trial;
      }
      Schedule schedule;
      schedule.metric = metric;
      schedule.lists.resize(shares.size() + 1);
      schedule.limits = thresholds;
      EXPECT_EQ(problem_of(schedule), "") << "a schedule takes them";
    }
  }
}

TEST(SolvedThresholds, EqualMeasuresAreNeverParted) {
  const auto metric = make_metric("distance");
  const std::vector<double> measures{1.0, 2.0, 2.0, 2.0, 2.0, 3.0};
  const auto in_first = [&](double share) {
    return counts(thresholds_for({share}, measures, *metric), measures, *metric)[0];
  };
  EXPECT_EQ(in_first(2.0 / 6.0), 1U) << "one pair off rather than three";
  EXPECT_EQ(in_first(0.5), 1U) << "as far either way: fewer";
  EXPECT_EQ(in_first(4.0 / 6.0), 5U);
  EXPECT_EQ(in_first(0.0), 0U);
  EXPECT_EQ(in_first(1.0), 6U);
}

TEST(SolvedThresholds, NeighbouringNumbersAreParted) {
  const double next = std::nextafter(1.0, 2.0);
  for (const char* name : {"distance", "size"}) {
    const auto metric = make_metric(name);
    EXPECT_EQ(counts(thresholds_for({0.5}, {1.0, next}, *metric), {1.0, next}, *metric)[0], 1U);
  }
}

std::string refusal(const std::vector<double>& shares, const std::vector<double>& measures) {
  try {
    thresholds_for(shares, measures, *make_metric("distance"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SolvedThresholds, WhatCannotBeSolvedIsNamed) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({-0.5}, {1.0}), "thresholds: expected pair shares in [0, 1], got -0.500000");
  EXPECT_EQ(refusal({0.5, 0.6}, {1.0}),
            "thresholds: expected pair shares of at most 1 together, got 1.100000");
  EXPECT_EQ(refusal({0.5}, {}),
            "thresholds: expected finite measures of at least one pair, got none");
  EXPECT_EQ(
      refusal({0.5}, {1.0, infinity}),
      "thresholds: expected finite measures of at least one pair, got one that is not finite");
  EXPECT_EQ(refusal({0.1, 0.2, 0.7}, {1.0}), "accepted");
}

Schedule by_shares(std::vector<double> shares) {
  Schedule schedule;
  schedule.metric = make_metric("distance");
  schedule.rule = make_list_rule("pair_shares");
  schedule.lists.resize(shares.size() + 1);
  schedule.limits = std::move(shares);
  return schedule;
}

TEST(PairShares, EachListTakesItsShareOfTheStepsPairsByRank) {
  RandomStream random(kSeed, "ranks");
  const Viewer viewer = viewer_at({0.5, 0.3, 1600, 900, 0.5}, 0.0);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<PairBounds> pairs;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(1 + random.below(60)); ++i) {
      // Whole places, so that many are as near.
      const Vector3 place(0.0, 0.0, -static_cast<double>(random.below(8)));
      pairs.push_back({{i, i + 1}, {place, 0.1}, {place, 0.1}});
    }
    const std::vector<ScheduledPair> order =
        scheduled(pairs, by_shares({0.5, 0.2}), viewer, {}, {});
    // Oracle: the order without lists, cut by rank.
    const std::vector<ScheduledPair> plain = scheduled(pairs, by_shares({}), viewer, {}, {});
    ASSERT_EQ(order.size(), pairs.size());
    const auto count = static_cast<double>(pairs.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const auto above = static_cast<double>(rank);
      EXPECT_EQ(order[rank].pair, plain[rank].pair);
      EXPECT_EQ(order[rank].list, above < std::floor(0.5 * count + 0.5)   ? 0
                                  : above < std::floor(0.7 * count + 0.5) ? 1
                                                                          : 2);
    }
  }
}

TEST(PairShares, ASchedulesProblemIsNamed) {
  EXPECT_EQ(problem_of(by_shares({0.5, 0.2})), "");
  EXPECT_EQ(problem_of(by_shares({1.0, 0.0})), "");
  EXPECT_EQ(problem_of(by_shares({std::nan("")})),
            "schedule: expected pair shares in [0, 1], got nan");
  EXPECT_EQ(problem_of(by_shares({0.8, 0.3})),
            "schedule: expected pair shares of at most 1 together, got 1.100000");
  Schedule one_missing = by_shares({0.5});
  one_missing.lists.emplace_back();
  EXPECT_EQ(problem_of(one_missing), "schedule: expected 2 pair shares, got 1");
  Schedule no_list;
  no_list.limits = {0.5};
  EXPECT_EQ(problem_of(no_list), "schedule: expected 0 thresholds, got 1");
  no_list.rule = make_list_rule("region");
  no_list.lists.emplace_back();
  EXPECT_EQ(problem_of(no_list), "schedule: expected no limits, got 1");
  Schedule forgetful;
  forgetful.persistence_steps = -1;
  EXPECT_EQ(problem_of(forgetful), "schedule: expected a persistence of at least 0 steps, got -1");
}

}  // namespace impetus::solved_thresholds_test
