// The step as a budgeted computation and as a pure function: what was granted, logged and granted
// again, gives the same bits.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "engine/world/world.hpp"
#include "tests/engine/head_on.hpp"

namespace impetus::step_work_test {

constexpr std::uint64_t kSeed = 1'637;

/// A meter as a live deadline makes it: it grants in slices, and from some total on refuses.
class SlicedWork final : public WorkMeter {
 public:
  SlicedWork(std::int64_t slice, std::int64_t refuse_from)
      : slice_(slice), refuse_from_(refuse_from) {}

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t /*reserved*/) override {
    std::int64_t& granted = granted_[static_cast<std::size_t>(phase)];
    while (granted < total && granted < refuse_from_) {
      granted += slice_;
    }
    return granted;
  }

 private:
  std::int64_t slice_;
  std::int64_t refuse_from_;
  std::array<std::int64_t, kWorkPhases> granted_{};
};

TEST(World, ReplayWithTheLoggedTotalGivesTheSameHashes) {
  RandomStream random(kSeed, "deadlines");
  int cut_short = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    World live = random_tree_world(seed, 5);
    World replay = live;
    for (int step = 0; step < 300; ++step) {
      SlicedWork deadline(1 + static_cast<std::int64_t>(random.below(50)),
                          static_cast<std::int64_t>(random.below(400)));
      const StepReport shown = live.step(step_of(kStep_s), deadline);
      FixedWork logged(grants_of(shown));
      const StepReport again = replay.step(step_of(kStep_s), logged);
      ASSERT_EQ(again.state.hash, shown.state.hash) << "seed " << seed << ", step " << step;
      ASSERT_EQ(again.work_spent, shown.work_spent);
      ASSERT_EQ(again.degradations, shown.degradations);
      for (const CollisionReport& collision : shown.collisions) {
        cut_short += collision.stop == StopReason::kBudgetSpent ? 1 : 0;
      }
    }
  }
  EXPECT_GT(cut_short, 100) << "the deadlines never cut a refinement short";
}

TEST(World, ReplayOfAFixedBudgetGivesTheSameHashes) {
  for (const std::int64_t budget : {0, 1, 5, 20, 100, 1'000, 1'000'000}) {
    World live = random_tree_world(3, 5);
    World replay = live;
    for (int step = 0; step < 200; ++step) {
      FixedWork meter(budget);
      const StepReport shown = live.step(step_of(kStep_s), meter);
      FixedWork logged(shown.work_granted);
      ASSERT_EQ(replay.step(step_of(kStep_s), logged).state.hash, shown.state.hash)
          << "budget " << budget << ", step " << step;
    }
  }
}

TEST(World, WorkNeverExceedsTheGrantExceptForTheFloor) {
  for (const std::int64_t budget : {0, 3, 17, 60, 400}) {
    World world = random_tree_world(4, 5);
    for (int step = 0; step < 300; ++step) {
      FixedWork meter(budget);
      const StepReport report = world.step(step_of(kStep_s), meter);
      ASSERT_LE(report.work_spent, std::max(budget, report.work_floor));
      ASSERT_LE(report.work_granted, budget);
      const bool over = report.work_floor > budget;
      ASSERT_EQ((report.degradations & kFloorOverBudget) != 0, over);
      ASSERT_TRUE(!over || report.work_spent == report.work_floor);
    }
  }
}

TEST(World, WorkIsTheNumberOfNodePairTests) {
  // Roots: 1 test. Two children each, all near: 4 more; 1 + 4 = 5.
  const std::vector<VolumeNode> nodes{{Sphere{Vector3::Zero(), 1.0}, 1, 2, {}},
                                      {Sphere{Vector3(0.1, 0.0, 0.0), 0.9}, 0, 0, {}},
                                      {Sphere{Vector3(-0.1, 0.0, 0.0), 0.9}, 0, 0, {}}};
  const VolumeTree tree(nodes, {0, 1});
  BodyModel model = ball(1.0, 1.0);
  model.tree = std::make_shared<VolumeTree>(tree);
  const World start({model, model}, {resting_at(Vector3::Zero()), resting_at({1.0, 0.0, 0.0})}, {});
  const auto spent_of = [&start](std::int64_t budget) {
    World world = start;
    FixedWork meter(budget);
    return world.step(step_of(kStep_s), meter);
  };
  EXPECT_EQ(spent_of(4).work_spent, 1) << "a block starts only when it is covered";
  EXPECT_EQ(spent_of(4).collisions[0].level, 0);
  EXPECT_EQ(spent_of(4).collisions[0].stop, StopReason::kBudgetSpent);
  EXPECT_EQ(spent_of(5).work_spent, 5);
  EXPECT_EQ(spent_of(5).collisions[0].level, 1);
  EXPECT_EQ(spent_of(kUnlimitedTests).work_spent, 5);
  EXPECT_EQ(spent_of(kUnlimitedTests).work_granted, 5);
}

TEST(World, ABudgetThatDoesNotCoverTheFloorIsFlagged) {
  World world = head_on(2.0, 3.0, 2.0, -1.0);
  FixedWork nothing(0);
  const StepReport report = world.step(step_of(kStep_s), nothing);
  EXPECT_EQ(report.degradations, static_cast<std::uint32_t>(kFloorOverBudget));
  EXPECT_EQ(report.work_floor, 1);
  EXPECT_EQ(report.work_spent, 1) << "the coarsest level is done whatever the budget";
  EXPECT_EQ(report.collisions.size(), 1U);
}

TEST(World, MoreWorkGoesDeeperAndFewerCollisionsAreFalse) {
  // Coarse levels bound finer ones: a pair that is apart at a coarse level is apart at a finer one.
  int resolved_away = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    World start = random_tree_world(seed, 5);
    for (int step = 0; step < 100; ++step) {
      World coarse = start;
      World fine = start;
      FixedWork little(1);
      const StepReport rough = coarse.step(step_of(kStep_s), little);
      const StepReport exact = step_whole(fine);
      ASSERT_LE(exact.collisions.size(), rough.collisions.size());
      resolved_away += static_cast<int>(rough.collisions.size() - exact.collisions.size());
      for (const CollisionReport& collision : exact.collisions) {
        EXPECT_EQ(collision.stop, StopReason::kFinest);
      }
      start = fine;
    }
  }
  EXPECT_GT(resolved_away, 50);
}

TEST(World, TwoWorldsInLockStepAndASnapshotResumedAgree) {
  World world = random_tree_world(kSeed, 5, {0.9, 0.02});
  World twin = random_tree_world(kSeed, 5, {0.9, 0.02});
  World snapshot = world;
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < 400; ++step) {
    FixedWork meter(150);
    FixedWork twins_meter(150);
    hashes.push_back(world.step(step_of(kStep_s), meter).state.hash);
    ASSERT_EQ(twin.step(step_of(kStep_s), twins_meter).state.hash, hashes.back()) << step;
    if (step == 170) {
      snapshot = world;
    }
  }
  for (std::size_t step = 171; step < 400; ++step) {
    FixedWork meter(150);
    ASSERT_EQ(snapshot.step(step_of(kStep_s), meter).state.hash, hashes[step]) << step;
  }
}

TEST(World, AChangedStartIsNoticedInTheFirstHash) {
  World world = random_tree_world(kSeed, 3);
  World changed = world;
  double& x = changed.mutable_states()[2].pose.position.x();
  x = std::nextafter(x, 10.0);
  const StepReport one = step_whole(world);
  const StepReport other = step_whole(changed);
  EXPECT_NE(one.state.hash, other.state.hash);
  EXPECT_EQ(first_difference(one.state.bodies, other.state.bodies)->body, 2U);
}

TEST(World, TheGoldenSceneEndsInTheCommittedHash) {
  // Equal for GCC and Clang, -O0 and -O3, any instruction set. When a change of the engine is
  // meant to change what recordings replay to, raise kRecordingFormat and commit the new value.
  World world = random_tree_world(2002, 5, {0.9, 0.05});
  std::uint64_t hash = 0;
  for (int step = 0; step < 500; ++step) {
    FixedWork meter(200);
    hash = world.step(step_of(kStep_s), meter).state.hash;
  }
  EXPECT_EQ(hash, 0xbcfd35fd3e1c4520ULL);
}

}  // namespace impetus::step_work_test
