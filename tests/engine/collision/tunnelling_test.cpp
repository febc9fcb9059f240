// Fast bodies: bullets and plates of every kind of tree, at any speed. None gets through.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/stop_at_entry.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/shots.hpp"

namespace impetus::tunnelling_test {

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
  // Straight down on a static box of one node: everything is known, whichever body comes first.
  BodyModel floor = fixed_ball(1.0);
  floor.tree = std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), {1.0, 1.0, 0.005}, Quaternion::Identity()}));
  const BodyModel model = bullet();
  const BodyState falling = moving(model, {0.1, 0.2, 3.0}, {0.0, 0.0, -10.0});
  const WorldSettings settings = handled(Tunnelling::kStopAtEntry);
  for (const std::size_t shot : {0U, 1U}) {
    World world = shot == 0 ? World({model, floor}, {falling, {}}, settings)
                            : World({floor, model}, {{}, falling}, settings);
    const StepReport report = step_whole(world, 1.0);
    ASSERT_EQ(report.stopped.size(), 1U) << shot;
    EXPECT_EQ(report.stopped[0].bodies, (BodyPair{0, 1}));
    // They touch when the middle is .005 + .004 above the plane's middle; a hair more is allowed.
    const double touch = (3.0 - 0.009) / 10.0;
    EXPECT_GE(report.stopped[0].fraction, touch);
    EXPECT_LT(report.stopped[0].fraction, touch + 0.009 / 8.0 / 10.0 + 1e-12);
    EXPECT_EQ(report.degradations, std::uint32_t{kStoppedShort});
    ASSERT_EQ(report.collisions.size(), 1U);
    EXPECT_EQ(report.collisions[0].approach_m_s, 10.0);
    const BodyState& state = world.states()[shot];
    EXPECT_EQ(velocity(model, state), Vector3(0.0, 0.0, 10.0));
    EXPECT_NEAR(state.pose.position.z(), 0.009, 0.009 / 8.0 + 1e-12);
    EXPECT_TRUE(step_whole(world, 1.0).stopped.empty()) << "it leaves unhindered";
    EXPECT_NEAR(state.pose.position.z(), 10.009, 0.009 / 8.0 + 1e-12);
  }
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

struct Bodies {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
};

/// Bullets one behind the other, straight down on a static plate.
Bodies convoy(RandomStream& random, int count, double speed_m) {
  Bodies bodies{{plate("box", false)}, std::vector<BodyState>(1)};
  double height_m = uniform_in(random, 0.02, 0.02 + 0.5 * speed_m);
  for (int i = 0; i < count; ++i) {
    bodies.models.push_back(bullet());
    bodies.states.push_back(moving(bullet(), {0.01, 0.02, height_m}, {0.0, 0.0, -speed_m}));
    height_m += uniform_in(random, 0.009, 0.02);
  }
  return bodies;
}

/// Whether they are still one behind the other, and before the plate's middle.
bool in_order(const std::vector<BodyState>& states) {
  double ahead_m = 0.0;
  for (std::size_t body = 1; body < states.size(); ++body) {
    if (states[body].pose.position.z() <= ahead_m) {
      return false;
    }
    ahead_m = states[body].pose.position.z();
  }
  return true;
}

TEST(Tunnelling, AConvoyThatRunsIntoAPlateStaysOneBehindTheOther) {
  // Each bullet meets the one before it only because that one was stopped.
  RandomStream random(kSeed, "convoy");
  for (const int count : {2, 8, 20}) {
    for (int trial = 0; trial < 6; ++trial) {
      const double speed_m = 0.1 * std::ldexp(1.0, 2 * trial);
      const Bodies bodies = convoy(random, count, speed_m);
      World world(bodies.models, bodies.states, handled(Tunnelling::kStopAtEntry));
      const double energy = total_energy(world);
      std::size_t stopped = 0;
      for (int step = 0; step < 60; ++step) {
        const StepReport report = step_whole(world, 1.0);
        stopped += report.stopped.size();
        ASSERT_TRUE(in_order(world.states()))
            << "seed " << kSeed << ", " << count << " at " << speed_m << ", step " << step;
      }
      EXPECT_GT(stopped, 1U);
      EXPECT_NEAR(total_energy(world) / energy, 1.0, 1e-12);
    }
  }
}

/// Who stops in a step of a second, and where the bodies are then.
std::pair<std::vector<StoppedAtEntry>, std::vector<BodyState>> stopped(const Bodies& bodies,
                                                                       int most_stops) {
  std::vector<BodyState> states = bodies.states;
  std::vector<MovedBound> bounds;
  std::vector<PlacedTree> placed;
  for (std::size_t body = 0; body < states.size(); ++body) {
    const BodyModel& model = bodies.models[body];
    const double way_m = advance(model, states[body], 1.0);
    bounds.push_back({{states[body].pose.position, model.tree->bounding_radius_m()},
                      way_m,
                      model.inverse_mass > 0.0});
    placed.emplace_back(*model.tree);
  }
  const std::vector<PairBounds> candidates = candidate_pairs(bounds);
  const Stopping result =
      stop_at_entry({1.0, bodies.models, bodies.states, candidates, kUnlimitedLevel, WorkCosts{},
                     Rotation::kMidpoint, most_stops},
                    states, placed);
  return {result.stopped, states};
}

TEST(Tunnelling, BodiesThatMayStopNoMoreStopTogetherAtTheFirstEntry) {
  RandomStream random(kSeed, "together");
  for (int trial = 0; trial < 20; ++trial) {
    const Bodies bodies = convoy(random, 6, uniform_in(random, 0.1, 30.0));
    const auto [first, together] = stopped(bodies, static_cast<int>(random.below(2)));
    ASSERT_EQ(first.size(), 1U) << "the second would stop the first bullet once more";
    EXPECT_EQ(first[0].bodies, (BodyPair{0, 1}));
    EXPECT_TRUE(in_order(together));
    for (std::size_t body = 1; body < together.size(); ++body) {
      BodyState whole = bodies.states[body];
      advance(bodies.models[body], whole, 1.0);
      const Vector3 way = whole.pose.position - bodies.states[body].pose.position;
      const Vector3 taken = together[body].pose.position - bodies.states[body].pose.position;
      EXPECT_LT((taken - first[0].fraction * way).norm(), 1e-14 * way.norm());
    }
    const auto [one_by_one, settled] = stopped(bodies, kMostStops);
    EXPECT_EQ(one_by_one.at(0).fraction, first[0].fraction);
    EXPECT_TRUE(in_order(settled));
  }
}

TEST(Tunnelling, TestsOfASphereAndABoxCostWhatThoseOfAnyVolumesDo) {
  const auto floor_at = [](std::int64_t cost) {
    WorldSettings settings = handled(Tunnelling::kStopAtEntry);
    settings.costs.volume_test = cost;
    World world({plate("box", false), bullet()},
                {{}, moving(bullet(), {0.01, 0.02, 0.5}, {0.0, 0.0, -1.0})}, settings);
    const StepReport report = step_whole(world, 1.0);
    EXPECT_EQ(report.stopped.size(), 1U);
    return report.work_floor;
  };
  EXPECT_GT(floor_at(1), 5) << "tests of one root pair are not all";
  EXPECT_EQ(floor_at(3), 3 * floor_at(1));
}

TEST(Tunnelling, BodiesThatAFixedOneAloneConnectsStopEachAtItsOwnEntry) {
  const BodyModel model = bullet();
  const Bodies bodies{{plate("box", false), model, model},
                      {{},
                       moving(model, {-0.04, 0.0, 0.02}, {0.0, 0.0, -0.03}),
                       moving(model, {0.04, 0.0, 0.03}, {0.0, 0.0, -0.03})}};
  const auto [first, together] = stopped(bodies, 0);
  ASSERT_EQ(first.size(), 2U);
  const double hair_m = 0.009 / 8.0;  // that either may stop before it touches
  EXPECT_NEAR(first[1].fraction - first[0].fraction, 1.0 / 3.0, hair_m / 0.03);
  EXPECT_NEAR(together[1].pose.position.z(), together[2].pose.position.z(), hair_m);
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
      ASSERT_LE(world.states()[0].pose.position.cwiseAbs().maxCoeff(), 0.1 + 1e-9) << speed;
    }
  }
}

}  // namespace impetus::tunnelling_test
