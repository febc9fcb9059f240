// Fast bodies: bullets and plates of every kind of tree, at any speed. None gets through.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/collision/time_of_entry.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/one_of_each_kind.hpp"
#include "tests/engine/shots.hpp"

namespace impetus {
namespace {

constexpr std::uint64_t kSeed = 63;
class PlatesOfKind : public testing::TestWithParam<std::string> {};

TEST_P(PlatesOfKind, NoBulletGetsThroughAtAnySpeedOrAngle) {
  RandomStream random(kSeed, "bullets/" + GetParam());
  int shots = 0;
  int hits = 0;
  for (double speed = 0.1; speed < 1.5e5; speed *= 3.1) {
    for (const bool movable : {false, true}) {
      const BodyModel target = plate(GetParam(), movable);
      const Shot shot =
          shoot(shot_at_plate(random, target, speed, handled(Tunnelling::kStopAtEntry)),
                steps_for(speed));
      EXPECT_EQ(shot.passed, 0) << "seed " << kSeed << ", speed " << speed << ", " << movable;
      EXPECT_NEAR(shot.energy_gained, 0.0, 1e-12);
      if (movable) {
        EXPECT_LT(shot.momentum_lost, 1e-14);
      }
      hits += shot.touched > 0 ? 1 : 0;
      ++shots;
    }
  }
  EXPECT_GT(hits, shots * 2 / 3);
}

TEST_P(PlatesOfKind, WithoutItTheSameBulletsDoGetThrough) {
  RandomStream random(kSeed, "ignored/" + GetParam());
  int passed = 0;
  for (double speed = 10.0; speed < 1.5e5; speed *= 3.1) {
    const BodyModel target = plate(GetParam(), false);
    passed += shoot(shot_at_plate(random, target, speed, handled(Tunnelling::kIgnored)), 25).passed;
  }
  EXPECT_GE(passed, 6);
}

TEST_P(PlatesOfKind, NoBulletGetsThroughASpinningPlate) {
  RandomStream random(kSeed, "spinning/" + GetParam());
  const BodyModel target = plate(GetParam());
  int stopped = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const double speed = std::ldexp(1.0, trial - 2);
    World world = shot_at_plate(random, target, speed, handled(Tunnelling::kStopAtEntry), 0.4);
    BodyState& spinning = world.mutable_states()[0];
    spinning.angular_momentum = angular_momentum_at(target, spinning.pose.orientation,
                                                    random_in_cube(random, 0.6));  // a step
    const Shot shot = shoot(world, steps_for(speed));
    EXPECT_EQ(shot.passed, 0) << "seed " << kSeed << ", trial " << trial;
    EXPECT_LT(shot.momentum_lost, 1e-14);
    stopped += shot.stopped;
  }
  EXPECT_GT(stopped, 5);
}

INSTANTIATE_TEST_SUITE_P(Tunnelling, PlatesOfKind,
                         testing::Values("octree", "medial", "voxel", "box", "swept",
                                         "heterogeneous"),
                         [](const auto& kind) { return kind.param; });

TEST(Tunnelling, ABulletStopsWhereItTouchesAndBouncesOff) {
  // Straight down on a static box of one node: everything is known.
  BodyModel floor = fixed_ball(1.0);
  floor.tree = std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), {1.0, 1.0, 0.005}, Quaternion::Identity()}));
  const BodyModel model = bullet();
  World world({floor, model}, {{}, moving(model, {0.1, 0.2, 3.0}, {0.0, 0.0, -10.0})},
              handled(Tunnelling::kStopAtEntry));
  const StepReport report = step_whole(world, 1.0);
  ASSERT_EQ(report.stopped.size(), 1U);
  EXPECT_EQ(report.stopped[0].bodies, (BodyPair{0, 1}));
  // They touch when the middle is .005 + .004 above the plane's middle; a hair more is allowed.
  const double touch = (3.0 - 0.009) / 10.0;
  EXPECT_GE(report.stopped[0].fraction, touch);
  EXPECT_LT(report.stopped[0].fraction, touch + 0.009 / 8.0 / 10.0 + 1e-12);
  EXPECT_EQ(report.degradations, std::uint32_t{kStoppedShort});
  ASSERT_EQ(report.collisions.size(), 1U);
  EXPECT_EQ(report.collisions[0].approach_m_s, 10.0);
  EXPECT_EQ(velocity(model, world.states()[1]), Vector3(0.0, 0.0, 10.0));
  EXPECT_NEAR(world.states()[1].pose.position.z(), 0.009, 0.009 / 8.0 + 1e-12);
  EXPECT_TRUE(step_whole(world, 1.0).stopped.empty()) << "it leaves unhindered";
  EXPECT_NEAR(world.states()[1].pose.position.z(), 10.009, 0.009 / 8.0 + 1e-12);
}

TEST(Tunnelling, TestsAlongTheWayAreWorkThatNoBudgetPrevents) {
  RandomStream random(kSeed, "work");
  World world = shot_at_plate(random, plate("octree"), 100.0, handled(Tunnelling::kStopAtEntry));
  World ignoring = world;
  bool stopped = false;
  for (int step = 0; step < 10 && !stopped; ++step) {
    FixedWork none(0);
    const StepReport report = world.step(step_of(1.0), none);
    EXPECT_EQ(report.work_spent, report.work_floor);
    if (!report.stopped.empty()) {
      EXPECT_GT(report.work_floor, 5) << "one pair's roots are one test";
      stopped = true;
    }
  }
  EXPECT_TRUE(stopped);
}

TEST(Tunnelling, ABulletThatMovesWithItsTargetIsNeverStopped) {
  const BodyModel target = plate("box");
  const BodyModel model = bullet();
  const Vector3 together(300.0, -200.0, 4'000.0);
  World world({target, model},
              {moving(target, Vector3::Zero(), together),
               moving(model, {0.0, 0.0, 0.0101}, together + Vector3(0.0, 0.0, -1e-5))},
              handled(Tunnelling::kStopAtEntry));
  for (int step = 0; step < 50; ++step) {
    const StepReport report = step_whole(world, 1.0);
    ASSERT_TRUE(report.stopped.empty()) << step;
    ASSERT_EQ(report.work_floor, 1) << "one pair, no way to test";
  }
}

TEST(Tunnelling, TwoBulletsAtOnceBothBounceOff) {
  RandomStream random(kSeed, "two bullets");
  const BodyModel target = plate("octree");
  const BodyModel model = bullet();
  for (int trial = 0; trial < 20; ++trial) {
    const auto shot_from = [&](double side) {
      const Vector3 place(uniform_in(random, -0.05, 0.05), uniform_in(random, -0.05, 0.05), 0.0);
      const double way_m = uniform_in(random, 1.0, 30.0);
      const Vector3 up(0.0, 0.0, side);
      return moving(model, place + uniform_in(random, 0.03, way_m) * up, -way_m * up);
    };
    const World world({target, model, model},
                      {{}, shot_from(1.0), shot_from(trial % 2 == 0 ? 1.0 : -1.0)},
                      handled(Tunnelling::kStopAtEntry));
    const Shot shot = shoot(world, 10);
    EXPECT_EQ(shot.passed, 0) << "seed " << kSeed << ", trial " << trial;
    EXPECT_GE(shot.touched, 2);
    EXPECT_LT(shot.momentum_lost, 1e-14);
    EXPECT_NEAR(shot.energy_gained, 0.0, 1e-12);
  }
}

/// Sixteen slow balls before a static plate, and a bullet that is shot into them.
World shot_into_crowd(RandomStream& random, double speed_m, Tunnelling tunnelling) {
  std::vector<BodyModel> models{plate("octree", false)};
  std::vector<BodyState> states(1);
  for (int i = 0; i < 16; ++i) {
    models.push_back(ball(0.01, 0.02));
    const Vector3 place(0.03 * (i % 4) - 0.045, 0.03 * (i / 4) - 0.045, 0.03 + 0.01 * (i % 3));
    states.push_back(moving(models.back(), place, random_in_cube(random, 1e-4)));
  }
  models.push_back(bullet());
  const Vector3 start(uniform_in(random, -0.05, 0.05), uniform_in(random, -0.05, 0.05), 0.2);
  states.push_back(moving(models.back(), start, {0.0, 0.0, -speed_m}));
  return {models, states, handled(tunnelling)};
}

TEST(Tunnelling, ABulletIntoACrowdSendsNobodyThroughThePlate) {
  RandomStream random(kSeed, "crowd");
  int passed_ignoring = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const double speed_m = 0.02 * std::ldexp(1.0, trial);
    RandomStream same = random;
    const Shot shot = shoot(shot_into_crowd(random, speed_m, Tunnelling::kStopAtEntry), 30);
    EXPECT_EQ(shot.passed, 0) << "seed " << kSeed << ", trial " << trial;
    EXPECT_NEAR(shot.energy_gained, 0.0, 1e-12);
    passed_ignoring += shoot(shot_into_crowd(same, speed_m, Tunnelling::kIgnored), 30).passed;
  }
  EXPECT_GT(passed_ignoring, 10);
}

TEST(Tunnelling, ABodyCannotLeaveItsWallsHoweverFast) {
  RandomStream random(kSeed, "walls");
  for (double speed = 0.1; speed < 1e6; speed *= 7.0) {
    WorldSettings settings = handled(Tunnelling::kStopAtEntry);
    settings.enclosure = ClosedCube{0.1};
    const BodyModel model = bullet();
    World world({model}, {moving(model, Vector3::Zero(), speed * random_direction(random))},
                settings);
    for (int step = 0; step < 60; ++step) {
      step_whole(world, 1.0);
      // Beyond a wall it is on its way back, so it is never further than one step takes it.
      ASSERT_LT(world.states()[0].pose.position.cwiseAbs().maxCoeff(), 0.1 + speed) << speed;
    }
  }
}

// h(level): the least half-width of the nodes that stand at the level.
TEST(HalfThickness, IsTheLeastOfTheNodesThatStandAtALevel) {
  RandomStream random(kSeed, "half thickness");
  for (int trial = 0; trial < 100; ++trial) {
    const VolumeTree tree = random_tree(random, 5);
    for (int level = 0; level < 7; ++level) {
      double least = 1e9;
      for (const std::int32_t node : tree.standing_at(level)) {
        least = std::min(least, std::get<Sphere>(tree.volume(node)).radius_m);
      }
      ASSERT_EQ(tree.least_half_thickness_m(level), least);
    }
  }
}

TEST(HalfThickness, OfEachKindIsHalfItsLeastWidth) {
  RandomStream random(kSeed, "widths");
  for (int trial = 0; trial < 50; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, Vector3::Zero(), 1.0)) {
      const CoredVolume whole = cored(volume);
      double least = 1e9;
      for (int i = 0; i < 400; ++i) {
        const Vector3 direction = random_direction(random);
        least = std::min(least, reach_along(whole.core, direction) + whole.radius_m);
      }
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3 direction = whole.core.axes.col(axis);
        least = std::min(least, reach_along(whole.core, direction) + whole.radius_m);
      }
      ASSERT_NEAR(least_half_width_m(volume), least, 1e-14);
    }
  }
}

TEST(RecursionCap, StaysAtLevelsWhoseNodesAreThickerThanTheWay) {
  const BodyModel target = plate("octree");
  const BodyModel model = plate("octree");
  const VolumeTree& tree = *target.tree;
  ASSERT_GE(tree.level_count(), 4);
  for (int level = 0; level + 1 < tree.level_count(); ++level) {
    // Just more than the next level's nodes allow, and no more than this one's.
    const double way_m = 1.001 * tree.least_half_thickness_m(level + 1);
    EXPECT_EQ(capped_level(tree, tree, way_m, kUnlimitedLevel), level);
    EXPECT_EQ(capped_level(tree, tree, way_m, 0), 0);
    World world({target, model},
                {moving(target, Vector3::Zero(), Vector3(7.0, 0.0, 0.0)),
                 moving(model, {0.001, 0.0, 0.0}, Vector3(7.0 + way_m, 0.0, 0.0))},
                handled(Tunnelling::kCapped));
    const StepReport report = step_whole(world, 1.0);
    ASSERT_EQ(report.collisions.size(), 1U);
    EXPECT_EQ(report.collisions[0].level, level);
    EXPECT_EQ(report.collisions[0].stop, StopReason::kCapped);
  }
  const double slow_m = 0.999 * tree.least_half_thickness_m(99);
  EXPECT_EQ(capped_level(tree, tree, slow_m, kUnlimitedLevel), kUnlimitedLevel);
  EXPECT_EQ(capped_level(tree, tree, 1e9, kUnlimitedLevel), 0) << "the coarsest is never refused";
}

TEST(RecursionCap, BodiesThatMoveTogetherAndSpinnersCountByTheirRelativeWay) {
  const BodyModel target = plate("octree");
  const auto stop_of = [&](const Vector3& velocity_m_s, double spin, int greatest_level) {
    BodyState spinning = moving(target, {0.001, 0.0, 0.0}, velocity_m_s);
    spinning.angular_momentum =
        angular_momentum_at(target, spinning.pose.orientation, {0.0, 0.0, spin});
    WorldSettings settings = handled(Tunnelling::kCapped);
    settings.schedule.lists[0].greatest_level = greatest_level;
    World world({target, target}, {moving(target, Vector3::Zero(), {50.0, 0.0, 0.0}), spinning},
                settings);
    return step_whole(world, 1.0).collisions.at(0).stop;
  };
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 0.0, kUnlimitedLevel), StopReason::kFinest);
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 1.0, kUnlimitedLevel), StopReason::kCapped);
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 1.0, 0), StopReason::kGreatestLevel) << "the list's own";
}

TEST(BodyPath, NoPointMovesFasterThanItsBound) {
  RandomStream random(kSeed, "paths");
  for (int trial = 0; trial < 200; ++trial) {
    const auto any_path = [&] {
      BodyPath path{{random_in_cube(random, 1.0), random_turn(random)},
                    {random_in_cube(random, 1.0), random_turn(random)}};
      path.begin = random.below(2) == 0 ? 0.0 : 0.5 * random.uniform();
      path.stop = random.below(2) == 0 ? 1.0 : path.begin + (1.0 - path.begin) * random.uniform();
      return path;
    };
    const BodyPath a = any_path();
    const BodyPath b = any_path();
    const Vector3 on_a = random_in_cube(random, 0.5);
    const Vector3 on_b = random_in_cube(random, 0.5);
    const auto stretches = stretches_of(a, b);
    const auto apart = [&](double time) {
      return Vector3(pose_at(a, time).transform(on_a) - pose_at(b, time).transform(on_b));
    };
    constexpr int kMoments = 500;
    for (int moment = 0; moment < kMoments; ++moment) {
      const double from = static_cast<double>(moment) / kMoments;
      const double to = static_cast<double>(moment + 1) / kMoments;
      const double bound_m = way_from(from, stretches, on_a.norm(), on_b.norm()) -
                             way_from(to, stretches, on_a.norm(), on_b.norm());
      ASSERT_LE((apart(to) - apart(from)).norm(), bound_m + 1e-12) << "seed " << kSeed;
    }
    EXPECT_EQ(pose_at(a, 1.0).position, a.end.position);
    EXPECT_EQ(pose_at(a, 0.0).position, a.start.position);
  }
}

/// How deep the finest nodes that the refinement reaches overlap at the moment; −1 when none do.
double depth_at(const PairOnTheWay& pair, double time) {
  pair.a.move_to(pose_at(pair.path_a, time));
  pair.b.move_to(pose_at(pair.path_b, time));
  PairRefinement refinement(pair.a, pair.b, pair.greatest_level);
  while (!refinement.resolved()) {
    refinement.refine_one_block();
  }
  double depth_m = -1.0;
  for (const NodePair& nodes : refinement.overlapping()) {
    const TouchPoint touch =
        touch_of_nodes(pair.a, nodes.a, pair.b, nodes.b, Vector3(Vector3::UnitX()));
    depth_m = std::max(depth_m, touch.depth_m);
  }
  return depth_m;
}

TEST(TimeOfEntry, IsTheFirstAtWhichTheRefinementFindsMoreThanAHair) {
  RandomStream random(kSeed, "entries");
  int entries = 0;
  int misses = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const VolumeTree tree_a = random_tree(random, 3);
    const VolumeTree tree_b = random_tree(random, 3);
    PlacedTree a(tree_a);
    PlacedTree b(tree_b);
    const Vector3 from = 4.0 * random_direction(random);
    const Vector3 to = random_in_cube(random, 3.0) - uniform_in(random, 0.0, 1.0) * from;
    const BodyPath path_a{{from, random_turn(random)}, {to, random_turn(random)}};
    const BodyPath path_b{{Vector3::Zero(), random_turn(random)},
                          {random_in_cube(random, 0.3), random_turn(random)}};
    const PairOnTheWay pair{a, b, path_a, path_b, static_cast<int>(random.below(4))};
    const double slow_m = slow_way_m(tree_a, tree_b, pair.greatest_level);
    const Entry entry = time_of_entry(pair);
    ASSERT_LT(entry.tests, kMostEntryTests);
    if (entry.time) {
      ++entries;
      ASSERT_GE(depth_at(pair, *entry.time), 0.0) << "they touch where they stop";
    } else {
      ++misses;
    }
    const auto stretches = stretches_of(path_a, path_b);
    for (int moment = 0; moment <= 500; ++moment) {
      const double time = moment / 500.0;
      const double left_m =
          way_from(time, stretches, tree_a.bounding_radius_m(), tree_b.bounding_radius_m());
      if (entry.time ? time <= *entry.time : left_m > 0.5 * slow_m) {
        ASSERT_LE(depth_at(pair, time), 0.125 * slow_m + 1e-12)
            << "seed " << kSeed << ", trial " << trial << ", time " << time;
      }
    }
  }
  EXPECT_GT(entries, 30);
  EXPECT_GT(misses, 30);
}

}  // namespace
}  // namespace impetus
