// WorldSettings::most_entry_tests: the searches along the ways of fast bodies never cost more, and
// pairs for which no tests are left are refined as if capped.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>

#include "engine/collision/broad_phase.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/shots.hpp"

namespace impetus::entry_limit_test {

constexpr std::uint64_t kSeed = 175;

/// Bodies of random trees that fly at the middle of them all, more or less, and fast.
World fast_crowd(std::uint64_t seed, std::int64_t most_entry_tests, double step_m = 0.8) {
  RandomStream random(seed, "fast crowd");
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  const Vector3 middle(0.0, 1.5, 1.5);
  for (int i = 0; i < 12; ++i) {
    const Vector3 place(3.0 * (i % 3 - 1), 3.0 * (i / 3 % 2), 3.0 * (i / 6 % 2));
    models.push_back(random_body(random, 4));
    states.push_back(
        moving(models.back(), place, step_m * (middle - place + random_direction(random))));
    states.back().pose.orientation = random_turn(random);
    states.back().angular_momentum = random_in_cube(random, 0.1);
  }
  WorldSettings settings;
  settings.rotation = Rotation::kEnergyKept;
  settings.most_entry_tests = most_entry_tests;
  return {std::move(models), std::move(states), settings};
}

/// What stops whom in a step of the crowd's, and where the bodies are then.
struct Stopped {
  Stopping result;
  std::vector<BodyState> states;
};

Stopped stopped_in(const World& world, std::int64_t most_tests) {
  Stopped stopped{{}, world.states()};
  std::vector<MovedBound> bounds;
  std::vector<PlacedTree> placed;
  for (std::size_t body = 0; body < stopped.states.size(); ++body) {
    const BodyModel& model = world.models()[body];
    const double way_m = advance(model, stopped.states[body], 1.0);
    bounds.push_back(
        {{stopped.states[body].pose.position, model.tree->bounding_radius_m()}, way_m, true});
    placed.emplace_back(*model.tree);
  }
  const std::vector<PairBounds> candidates = candidate_pairs(bounds);
  stopped.result = stop_at_entry({1.0,
                                  world.models(),
                                  world.states(),
                                  candidates,
                                  kUnlimitedLevel,
                                  WorkCosts{},
                                  Rotation::kMidpoint,
                                  kMostStops,
                                  {},
                                  most_tests},
                                 stopped.states, placed);
  return stopped;
}

bool at_the_same_places(const Stopped& x, const Stopped& y) {
  bool same = true;
  for (std::size_t body = 0; body < x.states.size(); ++body) {
    same = same && x.states[body].pose.position == y.states[body].pose.position &&
           x.states[body].pose.orientation.coeffs() == y.states[body].pose.orientation.coeffs();
  }
  return same;
}

TEST(EntryLimit, SearchesNeverTestMoreThanTheLimit) {
  int cut = 0;
  for (std::uint64_t crowd = 0; crowd < 20; ++crowd) {
    const World world = fast_crowd(kSeed + crowd, kUnlimitedTests);
    const Stopped whole = stopped_in(world, kUnlimitedTests);
    ASSERT_GT(whole.result.tests, 0);
    EXPECT_FALSE(whole.result.ran_out);
    EXPECT_TRUE(whole.result.unsearched.empty());
    for (const std::int64_t most : {0, 1, 7, 50, 300, 1'000, 5'000}) {
      const Stopped limited = stopped_in(world, most);
      ASSERT_LE(limited.result.tests, most) << "crowd " << kSeed + crowd;
      ASSERT_EQ(limited.result.work, limited.result.tests) << "a unit each";
      if (most > whole.result.tests) {
        EXPECT_FALSE(limited.result.ran_out);
        EXPECT_TRUE(at_the_same_places(limited, whole));
        EXPECT_EQ(limited.result.tests, whole.result.tests);
      } else {
        EXPECT_TRUE(limited.result.ran_out) << "crowd " << kSeed + crowd << ", " << most;
        ++cut;
      }
    }
  }
  EXPECT_GT(cut, 60);
  EXPECT_LT(cut, 139) << "some crowds need less than the highest limit";
}

TEST(EntryLimit, AMemoryThatSearchedBeforeFindsTheSame) {
  EntryMemory memory;
  for (std::uint64_t crowd = 0; crowd < 10; ++crowd) {
    const double step_m = crowd % 3 == 2 ? 1e-6 : 0.8;  // none is fast, now and then
    World fresh = fast_crowd(kSeed + crowd, 400, step_m);
    World used = fast_crowd(kSeed + crowd, 400, step_m);
    for (int step = 0; step < 5; ++step) {
      World again = used;  // whose memory is that of the steps before
      const StepReport report = step_whole(used, 1.0);
      World anew(fresh.models(), fresh.states(), fresh.settings());
      const StepReport other = step_whole(anew, 1.0);
      ASSERT_EQ(report.stopped.size(), other.stopped.size());
      ASSERT_EQ(report.degradations & kEntryTestsSpent, other.degradations & kEntryTestsSpent);
      ASSERT_EQ(step_whole(again, 1.0).state.hash, report.state.hash);
      fresh = used;
    }
  }
}

TEST(EntryLimit, NoTestsCapAllFastPairs) {
  const BodyModel target = plate("octree");
  const VolumeTree& tree = *target.tree;
  for (int level = 0; level + 1 < tree.level_count(); ++level) {
    // Just more than the next level's nodes allow, and more than is slow.
    const double way_m = std::max(1.001 * tree.least_half_thickness_m(level + 1),
                                  1.001 * slow_way_m(tree, tree, kUnlimitedLevel));
    const int capped = capped_level(tree, tree, way_m, kUnlimitedLevel);
    for (const std::int64_t most : {std::int64_t{0}, kUnlimitedTests}) {
      WorldSettings settings = handled(Tunnelling::kStopAtEntry);
      settings.most_entry_tests = most;
      World world({target, target},
                  {moving(target, Vector3::Zero(), Vector3(7.0, 0.0, 0.0)),
                   moving(target, {0.001, 0.0, 0.0}, Vector3(7.0 + way_m, 0.0, 0.0))},
                  settings);
      const StepReport report = step_whole(world, 1.0);
      ASSERT_EQ(report.collisions.size(), 1U);
      const CollisionReport& collision = report.collisions[0];
      EXPECT_EQ(collision.stop, most == 0 ? StopReason::kCapped : StopReason::kFinest);
      EXPECT_EQ(collision.level == capped, most == 0) << level;
      EXPECT_EQ((report.degradations & kEntryTestsSpent) != 0, most == 0);
    }
  }
}

TEST(EntryLimit, SlowPairsAreNotCapped) {
  const BodyModel target = plate("octree");
  WorldSettings settings = handled(Tunnelling::kStopAtEntry);
  settings.most_entry_tests = 0;
  const double way_m = 0.999 * slow_way_m(*target.tree, *target.tree, kUnlimitedLevel);
  World world({target, target},
              {moving(target, Vector3::Zero(), Vector3::Zero()),
               moving(target, {0.001, 0.0, 0.0}, Vector3(way_m, 0.0, 0.0))},
              settings);
  const StepReport report = step_whole(world, 1.0);
  ASSERT_EQ(report.collisions.size(), 1U);
  EXPECT_EQ(report.collisions[0].stop, StopReason::kFinest);
  EXPECT_EQ(report.degradations & kEntryTestsSpent, 0U);
}

TEST(EntryLimit, EnergyAndMomentumAreKeptWhereverTestsEnd) {
  int ran_out = 0;
  for (const std::int64_t most : {0, 20, 150, 800, 4'000}) {
    World world = fast_crowd(kSeed, most);
    const double energy = total_energy(world);
    const Vector3 momentum = total_momentum(world);
    int touched = 0;
    for (int step = 0; step < 20; ++step) {
      const StepReport report = step_whole(world, 0.2);
      ran_out += (report.degradations & kEntryTestsSpent) != 0 ? 1 : 0;
      touched += static_cast<int>(report.collisions.size());
    }
    EXPECT_GT(touched, 0);
    // Some turn by more than half a radian a step, where the rotation's iterations end early.
    EXPECT_NEAR(total_energy(world) / energy, 1.0, 1e-6) << most;
    EXPECT_LT((total_momentum(world) - momentum).norm(), 1e-12 * momentum.norm()) << most;
  }
  EXPECT_GT(ran_out, 5);
}

TEST(EntryLimit, TheFloorHoldsNoMoreThanTheLimitForSearches) {
  constexpr std::int64_t kMost = 500;
  World unlimited = fast_crowd(kSeed, kUnlimitedTests);
  World limited = fast_crowd(kSeed, kMost);
  World none = fast_crowd(kSeed, 0);
  const std::int64_t without = step_whole(none, 1.0).work_floor;
  const std::int64_t with = step_whole(limited, 1.0).work_floor;
  const std::int64_t whole = step_whole(unlimited, 1.0).work_floor;
  // Beside the searches the floor is the roots' tests, one a pair of the 12 bodies at most.
  EXPECT_LE(without, 66);
  EXPECT_LE(with, kMost + 66);
  EXPECT_GE(with, kMost);
  EXPECT_GT(whole, kMost + 66);
}

TEST(EntryLimit, LessThanNoTestsAreRefused) {
  try {
    fast_crowd(kSeed, -1);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "world: expected 0 or more tests of entry a step, got -1");
  }
}

}  // namespace impetus::entry_limit_test
