// SPDX-License-Identifier: MIT
#include "experiments/design/plan.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

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

}  // namespace impetus::plan_test
