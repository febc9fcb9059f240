// Persistence against popping, and the pops that happen all the same.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/priority_memory.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::persistence_test {

constexpr std::uint64_t kSeed = 531;

TEST(PriorityMemory, GivesATouchingPairTheHighestListItHadInTheStepsRemembered) {
  RandomStream random(kSeed, "straddling");
  int raised = 0;
  for (const std::int64_t steps : {0, 1, 2, 7}) {
    PriorityMemory memory;
    // Oracle: for each pair the lists of the last steps, as they come, without a list where it was
    // no candidate.
    constexpr int kAbsent = kMostLists;
    std::map<std::int32_t, std::deque<int>> history;
    std::vector<BodyPair> touching;
    for (int step = 0; step < 400; ++step) {
      std::vector<MeasuredPair> pairs;
      std::map<std::int32_t, int> expected;
      for (std::int32_t b = 1; b <= 8; ++b) {
        std::deque<int>& lists = history[b];
        const bool candidate = random.below(5) > 0;
        lists.push_front(candidate ? static_cast<int>(random.below(4)) : kAbsent);
        if (static_cast<std::int64_t>(lists.size()) > steps + 1) {
          lists.pop_back();
        }
        if (candidate) {
          const bool touched =
              std::find(touching.begin(), touching.end(), BodyPair{0, b}) != touching.end();
          expected[b] = touched ? *std::min_element(lists.begin(), lists.end()) : lists.front();
          raised += expected[b] < lists.front() ? 1 : 0;
          pairs.push_back({{{0, b}, lists.front()}, 0.0});
        }
      }
      memory.raise(pairs, steps);
      touching.clear();
      for (const MeasuredPair& pair : pairs) {
        ASSERT_EQ(pair.scheduled.list, expected[pair.scheduled.pair.b]) << "step " << step;
        if (random.below(2) == 0) {
          touching.push_back(pair.scheduled.pair);
        }
      }
      memory.note_touching(touching);
    }
  }
  EXPECT_GT(raised, 500);
}

TEST(PriorityMemory, ABodyTouchesTheEnclosureAtAnyWall) {
  PriorityMemory memory;
  const BodyPair at_walls{3, kEnclosure};
  std::vector<MeasuredPair> high{{{at_walls, 0}, 0.0}};
  memory.raise(high, 2);
  memory.note_touching({{3, wall_index(4)}, {3, wall_index(5)}});
  std::vector<MeasuredPair> low{{{at_walls, 1}, 0.0}};
  memory.raise(low, 2);
  EXPECT_EQ(low[0].scheduled.list, 0);
}

/// Two L-blocks that lie in each other, good within the region and bounding spheres outside it.
World two_touching_l_blocks(std::int64_t persistence_steps) {
  BodyModel model = solid_body(small_l_block(), 3);
  model.inverse_inertia.setZero();
  WorldSettings settings;
  settings.schedule.rule = make_list_rule("region");
  settings.schedule.lists = {{0.5, 0, kUnlimitedLevel}, {0.5, 0, 0}};
  settings.schedule.persistence_steps = persistence_steps;
  settings.restitution = 0.0;
  return {{model, model}, {resting_at({-0.01, 0.0, 0.0}), resting_at({0.01, 0.01, 0.0})}, settings};
}

StepInput gazing(bool at_the_pair) {
  StepInput input = step_of(kStep_s);
  input.region = GazeRegion{{at_the_pair ? 0.0 : 5.0, 0.0}, 3.0};
  return input;
}

/// Steps of a gaze that comes and goes every other step; the pops of each.
std::size_t pops_of_straddling(std::int64_t persistence_steps) {
  World world = two_touching_l_blocks(persistence_steps);
  std::size_t pops = 0;
  for (int step = 0; step < 40; ++step) {
    FixedWork all(kUnlimitedTests);
    pops += world.step(gazing(step % 2 == 0), all).pops.size();
  }
  return pops;
}

TEST(Persistence, APairThatStraddlesAThresholdPopsLess) {
  EXPECT_EQ(pops_of_straddling(0), 20U) << "every time it falls";
  EXPECT_EQ(pops_of_straddling(1), 0U);
  EXPECT_EQ(pops_of_straddling(5), 0U);
}

TEST(Persistence, APriorityThatHasFallenForGoodFallsInTheEnd) {
  World world = two_touching_l_blocks(3);
  for (int step = 0; step < 12; ++step) {
    FixedWork all(kUnlimitedTests);
    const StepReport report = world.step(gazing(step < 5), all);
    ASSERT_EQ(report.collisions.size(), 1U);
    EXPECT_EQ(report.collisions[0].list, step < 5 + 3 ? 0 : 1) << step;
    EXPECT_EQ(report.pops.size(), step == 5 + 3 ? 1U : 0U) << step;
  }
}

TEST(Persistence, TheBudgetWinsAndTheFallIsRecordedAsAPop) {
  World world = two_touching_l_blocks(10);
  FixedWork all(kUnlimitedTests);
  const StepReport good = world.step(gazing(true), all);
  ASSERT_EQ(good.collisions.size(), 1U);
  const int finest = good.collisions[0].level;
  ASSERT_GT(finest, 2);
  EXPECT_TRUE(good.pops.empty());
  FixedWork none(0);
  const StepReport cut = world.step(gazing(true), none);
  ASSERT_EQ(cut.pops.size(), 1U);
  const LevelPop& pop = cut.pops[0];
  EXPECT_EQ(pop.bodies, (BodyPair{0, 1}));
  EXPECT_EQ(pop.from, finest);
  EXPECT_EQ(pop.to, 0);
  // 2 atan(½ Δ / d): Δ of both trees, d from the eye to the contact.
  const VolumeTree& tree = *world.models()[0].tree;
  const double grown_m = 2.0 * (tree.fit_error_m(0) - tree.fit_error_m(finest));
  const double far_m = (cut.collisions[0].contact.touch.point - gazing(true).viewer.eye).norm();
  EXPECT_GT(pop.size_deg, 0.1);
  EXPECT_NEAR(pop.size_deg, 2.0 * std::atan(0.5 * grown_m / far_m) * 180.0 / std::numbers::pi,
              1e-12);
  FixedWork again(0);
  EXPECT_TRUE(world.step(gazing(true), again).pops.empty()) << "it stays where it fell";
}

TEST(Persistence, WithoutItNothingChanges) {
  World plain = enclosed_l_blocks(15, 3);
  Schedule schedule;
  schedule.persistence_steps = 0;
  World stated = enclosed_l_blocks(15, 3, schedule);
  schedule.persistence_steps = 5;
  World of_one_list = enclosed_l_blocks(15, 3, schedule);
  for (int step = 0; step < 200; ++step) {
    FixedWork meter(400);
    const std::uint64_t hash = plain.step(gazing(true), meter).state.hash;
    ASSERT_EQ(stated.step(gazing(true), meter).state.hash, hash);
    ASSERT_EQ(of_one_list.step(gazing(true), meter).state.hash, hash) << "one list: none higher";
  }
}

}  // namespace impetus::persistence_test
