// The budget of all phases: what was spent and what is still due fit into what was granted.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/collision/budgeted_refinement.hpp"
#include "tests/engine/crowds.hpp"
#include "tests/engine/once.hpp"

namespace impetus::phase_budget_test {

constexpr std::uint64_t kSeed = 39;

TEST(PhaseBudget, SpentAndReservedStayWithinTheBudgetOrTheFloorInSqueezedCrowds) {
  RandomStream random(kSeed, "squeezed");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  std::int64_t over = 0;
  std::int64_t cut = 0;
  std::int64_t nearly_all = 0;
  for (int crowd = 0; crowd < 12; ++crowd) {
    const WorldSettings settings = random_settings(random);
    World world = squeezed_crowd(random, kinds, 12, 0.12, settings);
    for (int step = 0; step < 40; ++step) {
      const auto budget =
          random.below(4) == 0 ? 0 : static_cast<std::int64_t>(random.below(40'000));
      FixedWork meter(budget);
      const StepReport report = world.step(looking_ahead(), meter);
      expect_within(report, budget, settings.costs);
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "crowd " << crowd << ", step " << step;
      over += report.work_floor > budget ? 1 : 0;
      nearly_all += 10 * report.work_peak > 9 * budget && report.work_floor < budget ? 1 : 0;
      for (const CollisionReport& collision : report.collisions) {
        cut += collision.stop == StopReason::kBudgetSpent ? 1 : 0;
      }
    }
  }
  EXPECT_GT(over, 50) << "the floor was never the bound";
  EXPECT_GT(cut, 200) << "the budget was never the bound";
  EXPECT_GT(nearly_all, 20) << "the budget is never used";
}

TEST(PhaseBudget, EveryMetersDecisionsReplayFromTheTotalItGranted) {
  RandomStream random(kSeed, "refusals");
  const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
  std::int64_t refused = 0;
  for (int crowd = 0; crowd < 6; ++crowd) {
    World live = squeezed_crowd(random, kinds, 12, 0.12, random_settings(random));
    World replay = live;
    for (int step = 0; step < 40; ++step) {
      RefusingWork meter(random, 1 + random.below(60));
      const StepReport shown = live.step(looking_ahead(), meter);
      FixedWork logged(grants_of(shown));
      const StepReport again = replay.step(looking_ahead(), logged);
      ASSERT_EQ(again.state.hash, shown.state.hash) << "crowd " << crowd << ", step " << step;
      ASSERT_EQ(again.work_spent, shown.work_spent);
      ASSERT_EQ(again.work_peak, shown.work_peak);
      ASSERT_EQ(again.list_work, shown.list_work);
      for (std::size_t i = 0; i < shown.collisions.size(); ++i) {
        ASSERT_EQ(again.collisions[i].level, shown.collisions[i].level);
        refused += shown.collisions[i].stop == StopReason::kBudgetSpent ? 1 : 0;
      }
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(PhaseBudget, TestsAloneCountUnlessCostsAreStated) {
  World plain = random_tree_world(3, 5);
  WorldSettings settings;
  settings.costs = {1, 1, 0, 0};
  World stated = random_tree_world(3, 5, settings);
  for (int step = 0; step < 300; ++step) {
    FixedWork meter(150);
    const StepReport one = plain.step(step_of(kStep_s), meter);
    const StepReport other = stated.step(step_of(kStep_s), meter);
    ASSERT_EQ(one.state.hash, other.state.hash);
    ASSERT_EQ(one.work_reserved, 0);
  }
}

/// Two balls that touch, with costs of 1, 10 and 100.
StepReport two_balls(std::int64_t budget) {
  WorldSettings settings;
  settings.costs = {1, 7, 10, 100};
  const BodyModel model = ball(0.1, 1.0);
  World world({model, model}, {resting_at({-0.09, 0, 0}), resting_at({0.09, 0, 0})}, settings);
  FixedWork meter(budget);
  return world.step(step_of(kStep_s), meter);
}

TEST(PhaseBudget, TheFloorPaysForTheRootsTheirModellingAndTheirResponse) {
  for (const std::int64_t budget : {std::int64_t{0}, std::int64_t{110}, std::int64_t{111}}) {
    const StepReport report = two_balls(budget);
    EXPECT_EQ(report.work_floor, 1 + 10 + 100);
    EXPECT_EQ(report.work_spent, 111) << "done whatever the budget";
    EXPECT_EQ(report.work_reserved, 110);
    EXPECT_EQ(report.work_peak, 111);
    EXPECT_EQ(report.work_granted, budget);
    EXPECT_EQ(report.degradations, budget < 111 ? kFloorOverBudget : 0U);
  }
}

/// A sphere whose children, two small ones, lie apart from anything at the origin's other side.
VolumeTree splits_away(double side) {
  return {{{Sphere{{0, 0, 0}, 0.1}, 1, 2, {}},
           {Sphere{{0.05 * side, 0.02, 0}, 0.01}, 0, 0, {}},
           {Sphere{{0.05 * side, -0.02, 0}, 0.01}, 0, 0, {}}},
          {0, 1}};
}

TEST(PhaseBudget, APairThatSeparatesReleasesItsReserve) {
  const VolumeTree left = splits_away(-1.0);
  const VolumeTree right = splits_away(1.0);
  const auto pair_of = [](PlacedTree& a, PlacedTree& b) {
    std::vector<RefinedPair> pairs;
    pairs.push_back({{0, 1}, 0, PairRefinement(a, b)});
    return pairs;
  };
  PlacedTree a(left);
  PlacedTree b(right);
  const RefinementSettings settings{make_traversal("depth-first"), {1, 1, 10, 100}, {}};
  // Before the block: 1 root + 4 tests + 4 nodes modelled + 1 averaged contact.
  constexpr std::int64_t kNeeded = 1 + 4 + 4 * 10 + 100;
  std::vector<RefinedPair> pairs = pair_of(a, b);
  FixedWork enough(kNeeded);
  const WorkDone done = refine_by_lists(pairs, {{}}, enough, settings);
  EXPECT_EQ(done.floor, 1 + 10 + 100);
  EXPECT_EQ(done.peak, kNeeded);
  EXPECT_EQ(done.spent, 5);
  EXPECT_EQ(done.reserved, 0) << "apart: nothing to model";
  std::vector<RefinedPair> refused = pair_of(a, b);
  FixedWork one_less(kNeeded - 1);
  const WorkDone kept = refine_by_lists(refused, {{}}, one_less, settings);
  EXPECT_EQ(kept.spent, 1);
  EXPECT_EQ(kept.reserved, 110);
  EXPECT_EQ(refused[0].refinement.stop_reason(), StopReason::kBudgetSpent);
}

BodyModel box_of_one_node() {
  BodyModel box = ball(0.1, 1.0);
  box.tree = std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), Vector3(0.1, 0.1, 0.1), Quaternion::Identity()}));
  return box;
}

/// Of a step with a ball of .1 m at x = .15 in a cube of 2 m, and `first` at `place`.
std::int64_t work_beside_a_ball(const BodyModel& first, const Vector3& place,
                                const WorkCosts& costs) {
  WorldSettings settings;
  settings.costs = costs;
  settings.enclosure = ClosedCube{1.0};
  World world({first, ball(0.1, 1.0)}, {resting_at(place), resting_at({0.15, 0.0, 0.0})}, settings);
  return step_whole(world).work_spent;
}

TEST(PhaseBudget, TestsOfOtherVolumesAndOfWallsCostTheirOwn) {
  const BodyModel box = box_of_one_node();
  const auto spent = [](const BodyModel& first, const Vector3& place) {
    return work_beside_a_ball(first, place, {1, 7, 0, 0});
  };
  EXPECT_EQ(spent(ball(0.1, 1.0), Vector3::Zero()), 1);
  EXPECT_EQ(spent(box, Vector3::Zero()), 7);
  EXPECT_EQ(spent(ball(0.1, 1.0), {-0.95, 0.0, 0.0}), 7) << "a node and a wall";
}

TEST(PhaseBudget, ModellingOfOtherVolumesCostsMoreAndThatOfWallsDoesNot) {
  const BodyModel box = box_of_one_node();
  const auto spent = [](const BodyModel& first, const Vector3& place) {
    return work_beside_a_ball(first, place, {1, 1, 10, 0, 500});
  };
  EXPECT_EQ(spent(ball(0.1, 1.0), Vector3::Zero()), 1 + 10);
  EXPECT_EQ(spent(box, Vector3::Zero()), 1 + 10 + 500);
  EXPECT_EQ(spent(box, {-0.95, 0.0, 0.0}), 1 + 10);
}

TEST(PhaseBudget, OnlyWallsWithinReachAreReservedFor) {
  WorldSettings settings;
  settings.costs = {1, 1, 0, 100};
  settings.enclosure = ClosedCube{1.0};
  const auto reserved = [&](const Vector3& place) {
    World world({ball(0.1, 1.0)}, {resting_at(place)}, settings);
    return step_whole(world).work_reserved;
  };
  EXPECT_EQ(reserved({0.95, 0.0, 0.0}), 100);
  EXPECT_EQ(reserved({0.95, 0.95, -0.95}), 300) << "a corner";
}

TEST(PhaseBudget, CostsOutOfRangeAreNamed) {
  EXPECT_EQ(problem_of(WorkCosts{}), "");
  EXPECT_EQ(problem_of(kAllPhases), "");
  EXPECT_EQ(problem_of(WorkCosts{0, 1, 0, 0}),
            "work costs: expected 1 to 1000000 units for a sphere test, got 0");
  EXPECT_EQ(problem_of(WorkCosts{1, -3, 0, 0}),
            "work costs: expected 1 to 1000000 units for a volume test, got -3");
  EXPECT_EQ(problem_of(WorkCosts{1, 1, -1, 0}),
            "work costs: expected 0 to 1000000 units for modelling, got -1");
  EXPECT_EQ(problem_of(WorkCosts{1, 1, 0, 1'000'001}),
            "work costs: expected 0 to 1000000 units for response, got 1000001");
  EXPECT_EQ(problem_of(WorkCosts{1, 1, 0, 0, -2}),
            "work costs: expected 0 to 1000000 units for modelling volumes, got -2");
  WorldSettings settings;
  settings.costs.sphere_test = 0;
  EXPECT_THROW(World({}, {}, settings), std::invalid_argument);
}

}  // namespace impetus::phase_budget_test
