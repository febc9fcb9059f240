// Orders of trials: blocks, Latin squares, catch trials, tracks, and rules that few orders keep to.
// SPDX-License-Identifier: MIT
#include "experiments/design/trial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::trial_order_test {

Factor numbered(const std::string& name, int levels) {
  Factor factor{name, {}};
  for (int level = 1; level <= levels; ++level) {
    factor.levels.emplace_back(static_cast<double>(level));
  }
  return factor;
}

double level_of(const PlannedTrial& trial, const std::string& factor) {
  for (const FactorLevel& level : trial.condition) {
    if (level.factor == factor) {
      return std::get<double>(level.value);
    }
  }
  return -1.0;
}

std::string participant(int number) { return "P" + std::to_string(number); }

/// 2 × `blocks` × 2 repetitions, in blocks of "level".
Design blocked(int blocks, Blocks::Order order) {
  Design design;
  design.factors = {numbered("delay", 2), numbered("level", blocks)};
  design.repetitions = 2;
  design.blocks = Blocks{{"level"}, order};
  return design;
}

std::vector<double> order_of_blocks(const Plan& plan) {
  std::vector<double> order;
  for (const PlannedTrial& trial : plan) {
    if (static_cast<std::size_t>(trial.block) > order.size()) {
      order.push_back(level_of(trial, "level"));
    }
  }
  return order;
}

// ---------------------------------------------------------------- blocks

TEST(BlockedPlan, EveryBlockHasItsLevelAloneAndAllOfItsCells) {
  for (int number = 1; number <= 30; ++number) {
    const Plan plan = make_plan(blocked(3, Blocks::Order::kRandom), {"x", participant(number), 5});
    ASSERT_EQ(plan.size(), 12U);
    std::map<std::int64_t, std::multiset<double>> delays;
    for (std::size_t index = 0; index < plan.size(); ++index) {
      ASSERT_EQ(plan[index].block, static_cast<std::int64_t>(index / 4) + 1);
      ASSERT_EQ(level_of(plan[index], "level"), level_of(plan[4 * (index / 4)], "level"));
      delays[plan[index].block].insert(level_of(plan[index], "delay"));
    }
    for (const auto& [block, seen] : delays) {
      EXPECT_EQ(seen, (std::multiset<double>{1, 1, 2, 2}));
    }
  }
}

TEST(BlockedPlan, FixedBlocksComeAsListedAndRandomOnesInEveryOrder) {
  std::set<std::vector<double>> orders;
  for (int number = 1; number <= 60; ++number) {
    const PlanKey key{"x", participant(number), 5};
    EXPECT_EQ(order_of_blocks(make_plan(blocked(3, Blocks::Order::kFixed), key)),
              (std::vector<double>{1, 2, 3}));
    orders.insert(order_of_blocks(make_plan(blocked(3, Blocks::Order::kRandom), key)));
  }
  EXPECT_EQ(orders.size(), 6U);
}

// Williams 1949: each condition equally often in each place, each after each other equally often.
TEST(WilliamsSquare, BalancesPlacesAndNeighboursForAnyNumberOfConditions) {
  for (std::size_t count = 1; count <= 9; ++count) {
    const auto rows = williams_square(count);
    const std::size_t expected_rows = count > 1 && count % 2 == 1 ? 2 * count : count;
    ASSERT_EQ(rows.size(), expected_rows);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> in_place;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> follows;
    for (const std::vector<std::size_t>& row : rows) {
      for (std::size_t place = 0; place < count; ++place) {
        ++in_place[{row[place], place}];
        if (place > 0) {
          ++follows[{row[place - 1], row[place]}];
        }
      }
    }
    ASSERT_EQ(in_place.size(), count * count);
    ASSERT_EQ(follows.size(), count * (count - 1));
    for (const auto& [pair, times] : in_place) {
      EXPECT_EQ(times, rows.size() / count);
    }
    for (const auto& [pair, times] : follows) {
      EXPECT_EQ(times, rows.size() / count);
    }
  }
}

TEST(BlockedPlan, TheNumberAtTheEndOfTheCodeIsTheRowOfTheLatinSquare) {
  const Design design = blocked(4, Blocks::Order::kLatinSquare);
  const auto rows = williams_square(4);
  const auto order_for = [&](const std::string& code) {
    return order_of_blocks(make_plan(design, {"x", code, 5}));
  };
  for (std::size_t row = 0; row < rows.size(); ++row) {
    std::vector<double> expected;
    for (const std::size_t condition : rows[row]) {
      expected.push_back(static_cast<double>(condition) + 1.0);
    }
    EXPECT_EQ(order_for("P0" + std::to_string(row + 1)), expected);
    EXPECT_EQ(order_for("P" + std::to_string(row + 5)), expected);
    // 10²⁰ is a multiple of 4: a number longer than any integer has its row too.
    EXPECT_EQ(order_for("lab2-10000000000000000000" + std::to_string(row + 1)), expected);
  }
}

TEST(BlockedPlan, ACodeWithoutANumberHasNoRow) {
  try {
    make_plan(blocked(3, Blocks::Order::kLatinSquare), {"x", "P01b", 5});
    FAIL() << "there is no number at the end";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--participant P01b: expected a code that ends in a number, such as P01, because "
                 "that number decides the order of the blocks, got \"P01b\"");
  }
}

// ---------------------------------------------------------------- runs

std::int64_t longest_run(const Plan& plan, const std::string& factor) {
  std::int64_t longest = 0;
  std::int64_t run = 0;
  for (std::size_t index = 0; index < plan.size(); ++index) {
    const bool equal =
        index > 0 && level_of(plan[index], factor) == level_of(plan[index - 1], factor);
    run = equal ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  return longest;
}

TEST(TrialOrder, RunsAreNotLongerAcrossBlocksEither) {
  Design design = blocked(3, Blocks::Order::kRandom);
  design.longest_runs = {{"delay", 2}};
  for (int number = 1; number <= 200; ++number) {
    const Plan plan = make_plan(design, {"x", participant(number), 5});
    ASSERT_LE(longest_run(plan, "delay"), 2) << number;
  }
}

// Of all orders of 3 × 20 trials, too few have no two equal neighbours for a shuffle to meet one.
TEST(TrialOrder, RulesThatAShuffleNeverMeetsAreKept) {
  Design design;
  design.factors = {numbered("delay", 3), numbered("view", 2)};
  design.repetitions = 10;
  design.longest_runs = {{"delay", 1}, {"view", 2}};
  const Plan plan = make_plan(design, {"x", "P01", 5});
  EXPECT_EQ(longest_run(plan, "delay"), 1);
  EXPECT_LE(longest_run(plan, "view"), 2);
  std::map<std::pair<double, double>, std::set<std::int64_t>> repetitions;
  for (const PlannedTrial& trial : plan) {
    repetitions[{level_of(trial, "delay"), level_of(trial, "view")}].insert(trial.repetition);
  }
  EXPECT_EQ(repetitions.size(), 6U);
  for (const auto& [cell, seen] : repetitions) {
    EXPECT_EQ(seen.size(), 10U);
  }
}

TEST(TrialOrder, OneOrderAloneIsFound) {
  // Ten trials of one level and nine of the other, never two alike in a row.
  Design design;
  design.factors = {{"delay", {1.0, 2.0}}};
  TrialBlocks blocks(1);
  for (int trial = 0; trial < 19; ++trial) {
    blocks[0].push_back({0, TrialPhase::kMain, 1, {{"delay", trial < 10 ? 1.0 : 2.0}}, 0});
  }
  RandomStream stream(3, "order");
  draw_order(blocks, {{"delay", 1}}, stream);
  for (std::size_t index = 0; index < 19; ++index) {
    EXPECT_EQ(level_of(blocks[0][index], "delay"), index % 2 == 0 ? 1.0 : 2.0);
  }
}

// Three trials of a, two of b, no more than two alike in a row: of the 10 patterns, aaabb, baaab
// and bbaaa are not permitted, and the others are equally likely.
TEST(TrialOrder, EveryPermittedOrderIsEquallyLikely) {
  RandomStream stream(31, "order");
  std::map<std::string, int> drawn;
  constexpr int kDraws = 9000;
  for (int draw = 0; draw < kDraws; ++draw) {
    TrialBlocks blocks(1);
    for (int trial = 0; trial < 5; ++trial) {
      blocks[0].push_back({0, TrialPhase::kMain, 1, {{"delay", trial < 3 ? 1.0 : 2.0}}, 0});
    }
    draw_order(blocks, {{"delay", 2}}, stream);
    std::string pattern;
    for (const PlannedTrial& trial : blocks[0]) {
      pattern += level_of(trial, "delay") == 1.0 ? 'a' : 'b';
    }
    ++drawn[pattern];
  }
  ASSERT_EQ(drawn.size(), 7U);
  double chi_square = 0.0;
  for (const auto& [pattern, times] : drawn) {
    const double expected = kDraws / 7.0;
    chi_square += (times - expected) * (times - expected) / expected;
  }
  EXPECT_LT(chi_square, 22.5);  // 6 degrees of freedom, 999 of 1000
}

// ---------------------------------------------------------------- catch trials

Design with_catches() {
  Design design = blocked(2, Blocks::Order::kFixed);
  design.repetitions = 6;
  design.catch_trials = {{{{"delay", 9.0}, {"level", 1.0}}, 2},
                         {{{"delay", 0.0}, {"level", 2.0}}, 1}};
  return design;
}

TEST(CatchTrials, AreInEveryBlockOneInEachStretchAndFlagged) {
  for (int number = 1; number <= 100; ++number) {
    const Plan plan = make_plan(with_catches(), {"x", participant(number), 5});
    ASSERT_EQ(plan.size(), 2U * (12 + 3));
    std::map<std::int64_t, std::vector<std::size_t>> main_before;
    std::map<std::int64_t, std::size_t> main_so_far;
    std::map<double, std::int64_t> kinds;
    for (const PlannedTrial& trial : plan) {
      if (trial.catch_trial) {
        main_before[trial.block].push_back(main_so_far[trial.block]);
        EXPECT_EQ(trial.repetition, ++kinds[level_of(trial, "delay")]);
        EXPECT_EQ(trial.phase, TrialPhase::kMain);
      } else {
        ++main_so_far[trial.block];
      }
    }
    EXPECT_EQ(kinds[9.0], 4);
    EXPECT_EQ(kinds[0.0], 2);
    for (const auto& [block, places] : main_before) {
      ASSERT_EQ(places.size(), 3U);
      // 13 places before, between and after 12 trials, in stretches of 4, 4 and 5.
      EXPECT_LT(places[0], 4U);
      EXPECT_TRUE(places[1] >= 4 && places[1] < 8);
      EXPECT_GE(places[2], 8U);
    }
  }
}

TEST(CatchTrials, LeaveTheOrderOfTheMainTrialsAsItIs) {
  Design without = with_catches();
  without.catch_trials.clear();
  const PlanKey key{"x", "P01", 5};
  std::vector<Condition> main;
  for (const PlannedTrial& trial : make_plan(with_catches(), key)) {
    if (!trial.catch_trial) {
      main.push_back(trial.condition);
    }
  }
  std::vector<Condition> expected;
  for (const PlannedTrial& trial : make_plan(without, key)) {
    expected.push_back(trial.condition);
  }
  EXPECT_EQ(main, expected);
}

TEST(CatchTrials, CountInTheRunsThatAreSeen) {
  Design design;
  design.factors = {numbered("delay", 2)};
  design.repetitions = 10;
  design.longest_runs = {{"delay", 3}};
  design.catch_trials = {{{{"delay", 1.0}}, 5}};
  for (int number = 1; number <= 100; ++number) {
    ASSERT_LE(longest_run(make_plan(design, {"x", participant(number), 5}), "delay"), 3) << number;
  }
}

// ---------------------------------------------------------------- tracks

Design adaptive_design() {
  Design design;
  design.factors = {numbered("gap", 5), numbered("level", 2)};
  design.adaptive = Adaptive{"gap", Staircase{1, 2, {1}, {5.0, 1.0}}, 10};
  return design;
}

TEST(AdaptivePlan, HasATrackForEachCellOfTheOthersAndEachStart) {
  const std::vector<TrackPlan> tracks = adaptive_tracks(adaptive_design());
  ASSERT_EQ(tracks.size(), 4U);
  EXPECT_EQ(tracks[0].condition, (Condition{{"level", 1.0}}));
  EXPECT_EQ(tracks[0].start, 4U);
  EXPECT_EQ(tracks[1].start, 0U);
  EXPECT_EQ(tracks[3].condition, (Condition{{"level", 2.0}}));
}

TEST(AdaptivePlan, InterleavesTracksAtRandomAndNumbersEachInTheOrderShown) {
  const Plan plan = make_plan(adaptive_design(), {"x", "P01", 5});
  ASSERT_EQ(plan.size(), 40U);
  std::map<std::int64_t, std::int64_t> shown;
  int changes = 0;
  for (std::size_t index = 0; index < plan.size(); ++index) {
    ASSERT_TRUE(plan[index].track);
    EXPECT_EQ(level_of(plan[index], "gap"), -1.0);  // not chosen yet
    EXPECT_EQ(plan[index].repetition, ++shown[*plan[index].track]);
    changes += index > 0 && plan[index].track != plan[index - 1].track ? 1 : 0;
  }
  for (std::int64_t track = 0; track < 4; ++track) {
    EXPECT_EQ(shown[track], 10);
  }
  EXPECT_GT(changes, 15);  // four tracks one after the other change three times
  EXPECT_EQ(plan, make_plan(adaptive_design(), {"x", "P01", 5}));
  EXPECT_NE(plan, make_plan(adaptive_design(), {"x", "P02", 5}));
}

}  // namespace impetus::trial_order_test
