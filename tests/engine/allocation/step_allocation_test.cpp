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

/// In the first of a crowd's rounds it gets as full as it ever will; then so many in a row are
/// quiet.
constexpr int kMostRounds = 8;
constexpr int kQuietRounds = 3;

/// Whether any of so many steps did.
bool allocates(World& world, int steps) {
  FixedWork unlimited(kUnlimitedTests);
  const StepInput input = looking_ahead();
  const std::int64_t before = allocated().calls;
  for (int step = 0; step < steps; ++step) {
    world.step(input, unlimited);
  }
  return allocated().calls > before;
}

/// Whether a crowd that comes back to the same state over and over allocates no more. What touched
/// and what is remembered of priorities go on from round to round, so it takes a few until it is as
/// full as it gets.
bool comes_to_allocate_nothing(const WorldSettings& settings,
                               std::shared_ptr<Workers> workers = nullptr) {
  RandomStream random(kSeed, "allocations");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  World world = squeezed_crowd(random, kinds, 24, 0.16, settings);
  world.watch_pairs(true);
  world.share_work_with(std::move(workers));
  const std::vector<BodyState> start = world.states();
  int quiet = 0;
  for (int round = 0; round < kMostRounds && quiet < kQuietRounds; ++round) {
    std::ranges::copy(start, world.mutable_states().begin());
    quiet = allocates(world, 30) ? 0 : quiet + 1;
  }
  return quiet == kQuietRounds;
}

TEST(StepAllocation, ACrowdOfEveryKindOfTreeAllocatesNothingOnceItWasAsFull) {
  EXPECT_TRUE(comes_to_allocate_nothing({}));
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
  EXPECT_TRUE(comes_to_allocate_nothing({}, workers));
  EXPECT_GT(workers->asked, 0);
}

TEST(StepAllocation, NorDoesAnyReduction) {
  for (const std::string_view name : reduction_names()) {
    WorldSettings settings;
    settings.contacts.reduction = make_reduction(name);
    settings.contacts.most_per_pair = 3;
    EXPECT_TRUE(comes_to_allocate_nothing(settings)) << name;
  }
}

TEST(StepAllocation, NorDoesAnyScheduleOrResponse) {
  RandomStream random(kSeed, "settings");
  for (int trial = 0; trial < 12; ++trial) {
    EXPECT_TRUE(comes_to_allocate_nothing(random_settings(random))) << "trial " << trial;
  }
}

}  // namespace impetus::step_allocation_test
