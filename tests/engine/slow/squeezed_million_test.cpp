// A million steps of squeezed crowds: the budget of all phases is kept in every one.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/squeezed_steps.hpp"

namespace impetus::squeezed_million_test {

TEST(PhaseBudgetLong, SpentAndReservedStayWithinTheBudgetOrTheFloorInAMillionSteps) {
  constexpr std::uint64_t kSeed = 40;
  constexpr int kCrowds = 2'000;
  constexpr int kSteps = 500;
  RandomStream random(kSeed, "a million squeezed steps");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  std::int64_t contacts = 0;
  std::int64_t over = 0;
  for (int crowd = 0; crowd < kCrowds; ++crowd) {
    WorldSettings settings = random_settings(random);
    if (crowd % 2 == 0) {
      settings.costs = kAllPhases;
    }
    const int bodies = 2 + static_cast<int>(random.below(5));
    World world = squeezed_crowd(random, kinds, bodies, 0.1, settings);
    for (int step = 0; step < kSteps; ++step) {
      const auto budget = random.below(8) == 0 ? 0 : static_cast<std::int64_t>(random.below(5'000));
      FixedWork meter(budget);
      const StepReport report = world.step(looking_ahead(), meter);
      expect_within(report, budget, settings.costs);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "crowd " << crowd << ", step " << step;
      contacts += static_cast<std::int64_t>(report.contacts.size());
      over += report.work_floor > budget ? 1 : 0;
    }
  }
  RecordProperty("contacts", std::to_string(contacts));
  RecordProperty("steps_over_their_budget", std::to_string(over));
  EXPECT_GT(contacts, 1'000'000);
  EXPECT_GT(over, 100'000);
}

TEST(PhaseBudgetLong, AnyPhaseCutAnywhereInAMillionStepsLeavesAValidAnswerThatReplays) {
  constexpr std::uint64_t kSeed = 41;
  constexpr int kCrowds = 4'000;
  constexpr int kSteps = 250;
  RandomStream random(kSeed, "a million cut steps");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  int steps_cut = 0;
  for (int crowd = 0; crowd < kCrowds; ++crowd) {
    WorldSettings settings = random_settings(random);
    settings.rotation = Rotation::kEnergyKept;
    const int bodies = 2 + static_cast<int>(random.below(5));
    SqueezedSteps seen;
    expect_squeezed_steps_hold(random, squeezed_crowd(random, kinds, bodies, 0.1, settings), kSteps,
                               1e-9, seen);
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "crowd " << crowd;
    steps_cut += seen.steps_cut;
  }
  EXPECT_GT(steps_cut, 800'000);
}

}  // namespace impetus::squeezed_million_test
