// SPDX-License-Identifier: MIT
#include "experiments/design/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/design/trial_order.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::plan_test {

std::string delays(const Plan& plan, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += to_text(plan[i].condition[0].value) + " ";
  }
  return text;
}

std::vector<std::string> conditions(const Plan& plan) {
  std::vector<std::string> texts;
  for (const PlannedTrial& trial : plan) {
    texts.push_back(to_json(trial.condition).dump());
  }
  return texts;
}

TEST(Plan, CausalityHas81BalancedTrialsAfterSixOfPractice) {
  const Plan plan = make_plan(causality().design, {"causality", "P01", 1});
  ASSERT_EQ(plan.size(), 87U);
  std::map<std::string, std::set<std::int64_t>> repetitions;
  for (const PlannedTrial& trial : plan) {
    if (trial.slot <= 6) {
      EXPECT_EQ(trial.phase, TrialPhase::kPractice);
    } else {
      repetitions[to_json(trial.condition).dump()].insert(trial.repetition);
    }
  }
  EXPECT_EQ(repetitions.size(), 27U);
  for (const auto& [condition, seen] : repetitions) {
    EXPECT_EQ(seen, (std::set<std::int64_t>{1, 2, 3})) << condition;
  }
}

TEST(Plan, NoMoreThanThreeEqualDelaysInARowForAnyParticipant) {
  const Design design = causality().design;
  for (int participant = 0; participant < 200; ++participant) {
    const Plan plan = make_plan(design, {"causality", "P" + std::to_string(participant), 7});
    int run = 0;
    for (std::size_t i = 6; i < plan.size(); ++i) {
      const bool equal = i > 6 && plan[i].condition[0] == plan[i - 1].condition[0];
      run = equal ? run + 1 : 1;
      ASSERT_LE(run, 3) << "participant " << participant << ", slot " << i + 1;
    }
  }
}

TEST(Plan, DependsOnProtocolParticipantAndSeedAlone) {
  const Design design = causality().design;
  const Plan plan = make_plan(design, {"causality", "P01", 1});
  EXPECT_EQ(plan, make_plan(design, {"causality", "P01", 1}));
  for (const PlanKey& other :
       {PlanKey{"gap", "P01", 1}, PlanKey{"causality", "P02", 1}, PlanKey{"causality", "P01", 2}}) {
    EXPECT_NE(conditions(plan), conditions(make_plan(design, other)));
  }
}

// A plan is a promise to every lab: the same order on every machine and in every later version.
TEST(Plan, OrderOfP01IsAsItAlwaysWas) {
  const Plan plan = make_plan(causality().design, {"causality", "P01", 1});
  EXPECT_EQ(delays(plan, 18), "0 300 100 300 0 100 100 0 100 0 100 300 0 300 100 300 0 0 ");
  EXPECT_EQ(plan[6].seed, 4927983330224995518U);
}

TEST(Plan, SeedsFitASignedColumnAndDiffer) {
  const Plan plan = make_plan(causality().design, {"causality", "P01", 1});
  std::set<std::uint64_t> seeds;
  for (const PlannedTrial& trial : plan) {
    EXPECT_LT(trial.seed, std::uint64_t{1} << 63);
    seeds.insert(trial.seed);
  }
  EXPECT_EQ(seeds.size(), plan.size());
}

TEST(Plan, AnOrderThatCannotExistIsRefused) {
  Design design;
  design.factors = {{"level", {1.0}}};
  design.repetitions = 4;
  design.longest_runs = {{"level", 3}};
  try {
    make_plan(design, {"x", "P01", 1});
    FAIL() << "four equal trials cannot avoid a run of four";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "no order of the trials that keeps to the longest runs was found in 100000 draws");
  }
}

// Of orders drawn blindly none in thousands keeps to the rules.
TEST(Plan, ManyCatchTrialsFindTheirPlacesAmongTheLongestRuns) {
  Design design;
  design.factors = {{"delay", {0.0, 100.0, 300.0}, "/delay"}, {"speed", {5.0, 10.0}, "/speed"}};
  design.repetitions = 40;
  design.longest_runs = {{"delay", 2}, {"speed", 3}};
  design.catch_trials = {{{{"delay", 500.0}, {"speed", 5.0}}, 40}};
  const Plan plan = make_plan(design, {"x", "P01", 1});
  ASSERT_EQ(plan.size(), 240U + 40U);
  EXPECT_TRUE(keeps_to({plan}, design.longest_runs));
  // Each in the stretch of the session that is its own.
  std::size_t main = 0;
  std::size_t caught = 0;
  for (const PlannedTrial& trial : plan) {
    if (trial.catch_trial) {
      EXPECT_GE(main, caught * 241 / 40);
      EXPECT_LE(main, (caught + 1) * 241 / 40);
      ++caught;
    } else {
      ++main;
    }
  }
  EXPECT_EQ(caught, 40U);
}

// ---------------------------------------------------------------- between participants

/// Three delays for everybody; two speeds × two kinds of region, of which a participant has one
/// each.
Design grouped_design() {
  Design design;
  design.factors = {{"speed", {5.0, 10.0}, "/speed"},
                    {"delay", {0.0, 100.0, 300.0}, "/delay"},
                    {"region", {std::string("fixed"), std::string("tracked")}, "/region"}};
  design.factors[0].between = design.factors[2].between = true;
  design.repetitions = 4;
  design.practice = {{{"delay", 300.0}}};
  design.catch_trials = {{{{"delay", 900.0}}, 1}};
  return design;
}

TEST(Plan, AParticipantHasOneLevelBetweenParticipantsInEveryTrial) {
  const Design design = grouped_design();
  const Condition group{{"speed", 10.0}, {"region", std::string("fixed")}};
  const Plan plan = make_plan(design, {"x", "P01", 5, group});
  ASSERT_EQ(plan.size(), 1U + 3U * 4U + 1U);
  std::map<std::string, int> shown;
  for (const PlannedTrial& trial : plan) {
    EXPECT_EQ(group_of(design, trial.condition), group);
    ASSERT_EQ(trial.condition.size(), 3U);
    EXPECT_EQ(trial.condition[1].factor, "delay") << "in the order of the design";
    ++shown[to_text(trial.condition[1].value)];
  }
  EXPECT_EQ(shown, (std::map<std::string, int>{{"0", 4}, {"100", 4}, {"300", 5}, {"900", 1}}));
}

TEST(Plan, WhoComesNextJoinsAGroupThatHasTheFewest) {
  const Design design = grouped_design();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::vector<Condition> earlier;
    for (int number = 1; number <= 40; ++number) {
      earlier.push_back(draw_group(design, {"x", "P" + std::to_string(number), seed}, earlier));
      std::vector<std::int64_t> sizes;
      for (const Condition& group : groups(design)) {
        sizes.push_back(std::count(earlier.begin(), earlier.end(), group));
      }
      const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
      ASSERT_LE(*most - *least, 1) << "seed " << seed << ", participant " << number;
    }
  }
}

TEST(Plan, AGroupIsDrawnBySeedAndCodeAmongThoseWithTheFewest) {
  const Design design = grouped_design();
  std::set<std::string> drawn;
  for (int number = 1; number <= 40; ++number) {
    const PlanKey key{"x", "P" + std::to_string(number), 7};
    EXPECT_EQ(draw_group(design, key, {}), draw_group(design, key, {}));
    drawn.insert(to_json(draw_group(design, key, {})).dump());
  }
  EXPECT_EQ(drawn.size(), 4U);
  EXPECT_EQ(make_plan(design, {"x", "P01", 7}),
            make_plan(design, {"x", "P01", 7, draw_group(design, {"x", "P01", 7}, {})}))
      << "without a group it is that of the study's first";
}

TEST(Plan, OfADesignWithinParticipantsNothingIsDrawnForGroups) {
  const Design design = causality().design;
  EXPECT_EQ(groups(design), std::vector<Condition>{Condition{}});
  EXPECT_EQ(make_plan(design, {"causality", "P01", 1, Condition{}}),
            make_plan(design, {"causality", "P01", 1}));
}

TEST(Plan, TracksOfAGroupStartAsThoseOfTheWholeDesignDo) {
  Design design = grouped_design();
  design.repetitions = 1;
  design.practice.clear();
  design.catch_trials.clear();
  design.adaptive = Adaptive{"delay", Staircase{1, 2, {1}, {0.0, 300.0}}, 6};
  const Condition group{{"speed", 10.0}, {"region", std::string("fixed")}};
  AdaptiveLevels levels(design);
  std::map<std::int64_t, LevelValue> starts;
  for (const PlannedTrial& trial : make_plan(design, {"x", "P01", 5, group})) {
    const Condition chosen = levels.choose(trial).condition;
    ASSERT_EQ(chosen.size(), 3U);
    starts.emplace(*trial.track, chosen[1].value);
  }
  EXPECT_EQ(starts, (std::map<std::int64_t, LevelValue>{{0, 0.0}, {1, 300.0}}));
}

// ---------------------------------------------------------------- blocks alike

/// How often each condition comes in each block.
std::map<std::int64_t, std::map<std::string, int>> shown_in_blocks(const Plan& plan) {
  std::map<std::int64_t, std::map<std::string, int>> shown;
  for (const PlannedTrial& trial : plan) {
    ++shown[trial.block][to_json(trial.condition).dump()];
  }
  return shown;
}

TEST(Plan, BlocksAlikeHaveEveryCellEquallyOften) {
  Design design;
  design.factors = {{"speed", {5.0, 10.0}, "/speed"}, {"delay", {0.0, 100.0, 300.0}, "/delay"}};
  design.repetitions = 6;
  const Plan without = make_plan(design, {"x", "P01", 5});
  design.blocks = Blocks{{}, Blocks::Order::kRandom, 3};
  const Plan plan = make_plan(design, {"x", "P01", 5});
  EXPECT_EQ(plan.size(), without.size());
  const auto shown = shown_in_blocks(plan);
  ASSERT_EQ(shown.size(), 3U);
  for (const auto& [block, conditions] : shown) {
    EXPECT_EQ(conditions.size(), 6U);
    for (const auto& [condition, times] : conditions) {
      EXPECT_EQ(times, 2) << block << ": " << condition;
    }
  }
  EXPECT_TRUE(std::is_sorted(plan.begin(), plan.end(),
                             [](const auto& a, const auto& b) { return a.block < b.block; }));
}

TEST(Plan, BlocksAlikeHaveEveryTrackEquallyOften) {
  Design design;
  design.factors = {{"speed", {5.0, 10.0}, "/speed"}, {"delay", {0.0, 100.0, 300.0}, "/delay"}};
  design.adaptive = Adaptive{"delay", Staircase{1, 2, {1}, {300.0}}, 8};
  design.blocks = Blocks{{}, Blocks::Order::kRandom, 4};
  for (const auto& [block, conditions] : shown_in_blocks(make_plan(design, {"x", "P01", 5}))) {
    EXPECT_EQ(conditions.size(), 2U) << block;
    for (const auto& [condition, times] : conditions) {
      EXPECT_EQ(times, 2) << block << ": " << condition;
    }
  }
}

/// Two blocks; before each trial of the second one comes what it adapts to.
Design adapting_design() {
  Design design;
  design.factors = {{"gap", {0.0, 1.0, 2.0}, "/gap"}, {"adapted", {"before", "after"}}};
  design.repetitions = 2;
  design.blocks = Blocks{{"adapted"}, Blocks::Order::kFixed};
  design.adaptation = {
      {{{"adapted", "after"}},
       {{{"gap", 7.0}, {"adapted", "after"}}, {{"gap", 8.0}, {"adapted", "after"}}},
       5,
       2}};
  return design;
}

TEST(Plan, AdaptationComesBeforeTheTrialsItIsFor) {
  const Plan plan = make_plan(adapting_design(), {"adapting", "P01", 1});
  ASSERT_EQ(plan.size(), 12U + 5U + 5U * 2U);
  std::int64_t shown = 0;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const bool is_adaptor = i >= 6 && (i < 11 || (i - 11) % 3 != 0);
    ASSERT_EQ(plan[i].phase, is_adaptor ? TrialPhase::kAdaptation : TrialPhase::kMain) << i;
    EXPECT_EQ(plan[i].block, i < 6 ? 1 : 2);
    EXPECT_EQ(plan[i].slot, static_cast<std::int64_t>(i) + 1);
    if (is_adaptor) {
      EXPECT_EQ(plan[i].condition[0].value, LevelValue(shown % 2 == 0 ? 7.0 : 8.0)) << "in turn";
      EXPECT_EQ(plan[i].repetition, ++shown);
    }
  }
}

TEST(Plan, AdaptationChangesNoOrder) {
  Design design = adapting_design();
  const Plan adapted = make_plan(design, {"adapting", "P01", 1});
  design.adaptation.clear();
  std::vector<std::string> shown;
  for (const PlannedTrial& trial : adapted) {
    if (trial.is_asked()) {
      shown.push_back(to_json(trial.condition).dump());
    }
  }
  EXPECT_EQ(shown, conditions(make_plan(design, {"adapting", "P01", 1})));
}

}  // namespace impetus::plan_test
