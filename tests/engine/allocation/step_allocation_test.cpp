// A step allocates nothing once its scene has been as full as it gets: every `new` is counted.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "tests/engine/allocation/counted_new.hpp"
#include "tests/engine/crowds.hpp"

namespace impetus::step_allocation_test {

constexpr std::uint64_t kSeed = 83;

/// In the first of a crowd's rounds it gets as full as it ever will.
constexpr int kRounds = 8;
constexpr int kRoundsToFill = 6;

/// The last step that allocated, of `steps`; -1 when none did.
int last_step_that_allocates(World& world, int steps) {
  FixedWork unlimited(kUnlimitedTests);
  const StepInput input = looking_ahead();
  int last = -1;
  for (int step = 0; step < steps; ++step) {
    const std::int64_t before = allocated().calls;
    world.step(input, unlimited);
    last = allocated().calls > before ? step : last;
  }
  return last;
}

/// A crowd that comes back to the same state over and over. What touched and what is remembered of
/// priorities go on from round to round, so it takes a few until it is as full as it gets.
int last_round_that_allocates(const WorldSettings& settings,
                              std::shared_ptr<Workers> workers = nullptr) {
  RandomStream random(kSeed, "allocations");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  World world = squeezed_crowd(random, kinds, 24, 0.16, settings);
  world.watch_pairs(true);
  world.share_work_with(std::move(workers));
  const std::vector<BodyState> start = world.states();
  int last = -1;
  for (int round = 0; round < kRounds; ++round) {
    std::ranges::copy(start, world.mutable_states().begin());
    last = last_step_that_allocates(world, 30) >= 0 ? round : last;
  }
  return last;
}

TEST(StepAllocation, ACrowdOfEveryKindOfTreeAllocatesNothingOnceItWasAsFull) {
  EXPECT_LT(last_round_that_allocates({}), kRoundsToFill);
}

/// Two, of whom one waits for the other.
class TwoInTurn final : public Workers {
 public:
  [[nodiscard]] int count() const override { return 2; }
  void run(const std::function<void(int worker)>& job) override {
    ++asked;
    job(1);
    job(0);
  }

  int asked{0};
};

TEST(StepAllocation, NorDoesOneThatIsShared) {
  const auto workers = std::make_shared<TwoInTurn>();
  EXPECT_LT(last_round_that_allocates({}, workers), kRoundsToFill);
  EXPECT_GT(workers->asked, 0);
}

TEST(StepAllocation, NorDoesAnyReduction) {
  for (const std::string_view name : reduction_names()) {
    WorldSettings settings;
    settings.contacts.reduction = make_reduction(name);
    settings.contacts.most_per_pair = 3;
    EXPECT_LT(last_round_that_allocates(settings), kRoundsToFill) << name;
  }
}

TEST(StepAllocation, NorDoesAnyScheduleOrResponse) {
  RandomStream random(kSeed, "settings");
  for (int trial = 0; trial < 12; ++trial) {
    EXPECT_LT(last_round_that_allocates(random_settings(random)), kRoundsToFill)
        << "trial " << trial;
  }
}

}  // namespace impetus::step_allocation_test
