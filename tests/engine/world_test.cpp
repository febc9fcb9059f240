// World: the step as physics, as a budgeted computation, and as a pure function.
// SPDX-License-Identifier: MIT
#include "engine/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/dynamics/motion.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {
namespace {

constexpr std::uint64_t kSeed = 1'637;

/// Two balls on the x axis that meet after two thirds of a step and then overlap.
World head_on(double mass_a_kg, double speed_a_m_s, double mass_b_kg, double speed_b_m_s,
              WorldSettings settings = {}) {
  const std::vector<BodyModel> models{ball(0.5, mass_a_kg), ball(0.5, mass_b_kg)};
  const double gap_m = (speed_a_m_s - speed_b_m_s) * kStep_s * (2.0 / 3.0);
  return {models,
          {moving(models[0], Vector3::Zero(), {speed_a_m_s, 0.0, 0.0}),
           moving(models[1], {1.0 + gap_m, 0.0, 0.0}, {speed_b_m_s, 0.0, 0.0})},
          settings};
}

double x_speed(const World& world, std::size_t body) {
  return velocity(world.models()[body], world.states()[body]).x();
}

TEST(World, TwoEqualBallsHeadOnExchangeTheirVelocities) {
  World world = head_on(2.0, 3.0, 2.0, -1.0);
  const StepReport report = step_whole(world);
  ASSERT_EQ(report.collisions.size(), 1U);
  const CollisionReport& collision = report.collisions.front();
  EXPECT_EQ(collision.bodies, (BodyPair{0, 1}));
  EXPECT_TRUE(collision.began);
  EXPECT_EQ(collision.contact.touch.normal, Vector3(-1.0, 0.0, 0.0)) << "from b to a";
  EXPECT_EQ(collision.approach_m_s, 4.0);
  // j = (1 + ε) v m_a m_b / (m_a + m_b)
  EXPECT_EQ(collision.impulse_Ns, 8.0);
  EXPECT_EQ(x_speed(world, 0), -1.0);
  EXPECT_EQ(x_speed(world, 1), 3.0);
  EXPECT_EQ(report.degradations, 0U);
}

TEST(World, UnequalBallsHeadOnLeaveAsTheEquationsSay) {
  // v_a' = (m_a v_a + m_b v_b − m_b ε (v_a − v_b)) / (m_a + m_b), and b alike
  const double mass_a = 0.7;
  const double mass_b = 2.3;
  for (const double restitution : {0.0, 0.3, 1.0}) {
    World world = head_on(mass_a, 2.0, mass_b, -0.5, {restitution, 0.0});
    step_whole(world);
    const double momentum = mass_a * 2.0 - mass_b * 0.5;
    const double total = mass_a + mass_b;
    // Ten roundings of numbers below 8.
    EXPECT_NEAR(x_speed(world, 0), (momentum - mass_b * restitution * 2.5) / total, 1e-14);
    EXPECT_NEAR(x_speed(world, 1), (momentum + mass_a * restitution * 2.5) / total, 1e-14);
  }
}

TEST(World, AnObliqueImpactKeepsTheSpeedAlongTheContactPlane) {
  const std::vector<BodyModel> models{ball(0.5, 1.0), ball(0.5, 1.0)};
  const Vector3 offset(0.6, 0.8, 0.0);
  World world(models,
              {moving(models[0], Vector3::Zero(), {3.0, 0.0, 0.0}), resting_at(offset * 1.001)},
              {});
  const StepReport report = step_whole(world);
  ASSERT_EQ(report.collisions.size(), 1U);
  const Vector3 normal = report.collisions[0].contact.touch.normal;
  const Vector3 velocity_b = velocity(models[1], world.states()[1]);
  const Vector3 velocity_a = velocity(models[0], world.states()[0]);
  // Equal masses: b takes all of a's speed along the normal, a keeps the rest.
  EXPECT_LT((velocity_b - 3.0 * normal.x() * normal).norm(), 1e-14);
  EXPECT_NEAR(velocity_a.dot(normal), 0.0, 1e-14);
  EXPECT_LT(world.states()[0].angular_momentum.norm(), 1e-14) << "central: nothing spins";
}

/// `count` balls that touch in a row of which one end is struck.
World cradle(int count, double mass_kg, bool from_the_left) {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    models.push_back(ball(0.5, mass_kg));
    states.push_back(resting_at({static_cast<double>(i), 0.0, 0.0}));
  }
  const double sign = from_the_left ? 1.0 : -1.0;
  BodyState& striker = from_the_left ? states.front() : states.back();
  striker.pose.position.x() -= sign * 0.001;
  striker.linear_momentum.x() = sign * mass_kg * 2.0;
  return {std::move(models), std::move(states), {}};
}

TEST(World, ANewtonsCradlePassesTheMomentumToTheLastBall) {
  for (int count = 2; count <= 8; ++count) {
    for (const bool from_the_left : {true, false}) {
      World world = cradle(count, 0.3, from_the_left);
      const StepReport report = step_whole(world);
      EXPECT_EQ(report.degradations, 0U) << count;
      const std::size_t last = from_the_left ? static_cast<std::size_t>(count) - 1 : 0;
      for (std::size_t body = 0; body < static_cast<std::size_t>(count); ++body) {
        const double expected = body == last ? (from_the_left ? 2.0 : -2.0) : 0.0;
        // A few roundings a contact.
        EXPECT_NEAR(x_speed(world, body), expected, 1e-14) << count << " balls, ball " << body;
      }
    }
  }
}

/// `count` balls in a cubic room of six large static balls, flying about.
World room_of_balls(std::uint64_t seed, int count, double restitution, bool with_walls) {
  RandomStream random(seed, "room of balls");
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    models.push_back(ball(uniform_in(random, 0.15, 0.3), uniform_in(random, 0.2, 3.0)));
    const Vector3 place(0.7 * (i % 3 - 1), 0.7 * (i / 3 % 3 - 1), 0.7 * (i / 9 % 3 - 1));
    const Vector3 inwards = with_walls ? Vector3::Zero() : Vector3(-place);
    states.push_back(moving(models.back(), place, inwards + random_in_cube(random, 2.0)));
    states.back().angular_momentum = random_in_cube(random, 0.01);
  }
  for (int wall = 0; with_walls && wall < 6; ++wall) {
    models.push_back(fixed_ball(50.0));
    Vector3 place = Vector3::Zero();
    place[wall % 3] = wall < 3 ? 51.5 : -51.5;
    states.push_back(resting_at(place));
  }
  return {std::move(models), std::move(states), {restitution, 0.0}};
}

TEST(World, ABoxOfBallsNeverGainsEnergy) {
  for (const double restitution : {1.0, 0.9, 0.5}) {
    World world = room_of_balls(kSeed, 20, restitution, /*with_walls=*/true);
    const double start = total_energy(world);
    double before = start;
    std::size_t impacts = 0;
    for (int step = 0; step < 3'000; ++step) {
      const StepReport report = step_whole(world);
      const double after = total_energy(world);
      // Twenty bodies' roundings; elastic impacts keep the energy but for them.
      ASSERT_LE(after, before + 1e-13 * start) << "seed " << kSeed << ", step " << step;
      before = after;
      for (const CollisionReport& collision : report.collisions) {
        impacts += collision.impulse_Ns > 0.0 ? 1 : 0;
      }
    }
    EXPECT_GT(impacts, 100U) << "hardly anything collided";
    if (restitution == 1.0) {
      EXPECT_NEAR(before, start, 1e-10 * start);  // 3,000 steps of 1e-14 at worst
    } else {
      EXPECT_LT(before, 0.5 * start) << "restitution " << restitution << " lost too little";
    }
  }
}

TEST(World, BallsAmongThemselvesKeepTheirMomentumAndAngularMomentum) {
  World world = room_of_balls(kSeed, 20, 0.8, /*with_walls=*/false);
  const Vector3 momentum = total_momentum(world);
  const Vector3 angular = total_angular_momentum(world);
  std::size_t impacts = 0;
  for (int step = 0; step < 2'000; ++step) {
    impacts += step_whole(world).collisions.size();
  }
  ASSERT_GT(impacts, 10U);
  // Rounding of sums near 100 over some hundred impacts; positions grow to 50 m.
  EXPECT_LT((total_momentum(world) - momentum).norm(), 1e-12);
  EXPECT_LT((total_angular_momentum(world) - angular).norm(), 1e-11);
}

TEST(World, TumblingBodiesOfManySpheresNeverGainEnergyInAnImpact) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    World world = random_tree_world(seed, 4);
    const Vector3 momentum = total_momentum(world);
    for (int step = 0; step < 600; ++step) {
      std::vector<BodyState> free = world.states();
      double before = 0.0;
      for (std::size_t body = 0; body < free.size(); ++body) {
        advance(world.models()[body], free[body], kStep_s);
        before += kinetic_energy(world.models()[body], free[body]);
      }
      step_whole(world);
      ASSERT_LE(total_energy(world), before * (1.0 + 1e-13)) << "seed " << seed << ", " << step;
    }
    EXPECT_LT((total_momentum(world) - momentum).norm(), 1e-12);
  }
}

TEST(World, StaticBodiesNeverMove) {
  World world = room_of_balls(kSeed, 20, 1.0, /*with_walls=*/true);
  const std::vector<BodyState> start = world.states();
  for (int step = 0; step < 1'000; ++step) {
    step_whole(world);
  }
  for (std::size_t wall = 20; wall < 26; ++wall) {
    EXPECT_EQ(world.states()[wall].pose.position, start[wall].pose.position);
    EXPECT_EQ(world.states()[wall].linear_momentum, Vector3::Zero());
    EXPECT_EQ(world.states()[wall].angular_momentum, Vector3::Zero());
  }
}

TEST(World, AnImposedHoldFreezesBothBodiesForTheTimeAskedAndThenTheyGo) {
  // 100 ms are 24 steps of 1/240 s; the hold starts at the end of the step of the contact.
  World world = head_on(2.0, 3.0, 2.0, -1.0, {1.0, 0.1});
  const StepReport contact = step_whole(world);
  ASSERT_EQ(contact.collisions.size(), 1U);
  EXPECT_EQ(contact.collisions[0].imposed_hold_s, 0.1);
  const std::vector<BodyState> touched = world.states();
  for (int step = 1; step <= 24; ++step) {
    const StepReport report = step_whole(world);
    ASSERT_EQ(report.collisions.size(), 1U) << "still touching";
    EXPECT_FALSE(report.collisions[0].began);
    EXPECT_EQ(report.collisions[0].imposed_hold_s, 0.0) << "one hold for one contact";
    for (std::size_t body = 0; body < 2; ++body) {
      // Rounding of 0.1 − 24/240 lets the last step move by 1e-17 s of travel.
      ASSERT_LT((world.states()[body].pose.position - touched[body].pose.position).norm(), 1e-16)
          << step;
    }
  }
  step_whole(world);
  // Exchanged velocities, one step.
  EXPECT_NEAR(world.states()[0].pose.position.x() - touched[0].pose.position.x(), -kStep_s, 1e-15);
  EXPECT_NEAR(world.states()[1].pose.position.x() - touched[1].pose.position.x(), 3.0 * kStep_s,
              1e-15);
}

TEST(World, AHoldThatEndsInMidStepMovesForTheRestOfIt) {
  // 10 ms of 240 Hz steps: held, held, then 0.4 of a step held and 0.6 free.
  World world = head_on(2.0, 3.0, 2.0, -1.0, {1.0, 0.01});
  step_whole(world);
  const BodyState touched = world.states()[1];
  for (int step = 0; step < 2; ++step) {
    step_whole(world);
    ASSERT_EQ(world.states()[1].pose.position, touched.pose.position);
  }
  const BodyState before = world.states()[1];
  step_whole(world);
  const BodyState after = world.states()[1];
  EXPECT_NEAR(after.held_fraction, 0.4, 1e-14);
  EXPECT_NEAR(after.pose.position.x() - touched.pose.position.x(), 3.0 * 0.6 * kStep_s, 1e-15);
  EXPECT_EQ(between(before, after, 0.3).position, touched.pose.position);
  // Half way through the free part.
  EXPECT_NEAR(between(before, after, 0.7).position.x() - touched.pose.position.x(),
              3.0 * 0.3 * kStep_s, 1e-15);
}

TEST(World, AContactThatLastsStartsNoSecondHold) {
  // c runs into b while a and b are held: b is driven at a again, but that contact began before.
  const std::vector<BodyModel> models{ball(0.5, 1.0), ball(0.5, 1.0), ball(0.5, 1.0)};
  World world(models,
              {moving(models[0], Vector3::Zero(), {1.0, 0.0, 0.0}), resting_at({1.001, 0.0, 0.0}),
               moving(models[2], {2.05, 0.0, 0.0}, {-5.0, 0.0, 0.0})},
              {1.0, 0.1});
  std::vector<BodyPair> holds;
  double impulse_while_held_Ns = 0.0;
  for (int step = 0; step < 20; ++step) {
    const double held_s = world.states()[0].held_s;
    for (const CollisionReport& collision : step_whole(world).collisions) {
      if (collision.imposed_hold_s > 0.0) {
        holds.push_back(collision.bodies);
      } else if (collision.bodies == BodyPair{0, 1}) {
        impulse_while_held_Ns += collision.impulse_Ns;
      }
    }
    EXPECT_TRUE(held_s == 0.0 || world.states()[0].held_s < held_s) << step;
  }
  EXPECT_EQ(holds, (std::vector<BodyPair>{{0, 1}, {1, 2}}));
  EXPECT_GT(impulse_while_held_Ns, 1.0) << "b was never driven at a again";
}

TEST(World, AHoldOfZeroChangesNothing) {
  World plain = head_on(2.0, 3.0, 2.0, -1.0);
  EXPECT_EQ(step_whole(plain).collisions[0].imposed_hold_s, 0.0);
  EXPECT_EQ(plain.states()[0].held_s, 0.0);
}

TEST(World, APairThatSeparatesAndMeetsAgainBeginsAgain) {
  // A ball bouncing between two walls.
  const std::vector<BodyModel> models{ball(0.5, 1.0), fixed_ball(5.0), fixed_ball(5.0)};
  World world(models,
              {moving(models[0], Vector3::Zero(), {4.0, 0.0, 0.0}), resting_at({6.0, 0.0, 0.0}),
               resting_at({-6.0, 0.0, 0.0})},
              {});
  std::vector<BodyPair> began;
  for (int step = 0; step < 300; ++step) {
    for (const CollisionReport& collision : step_whole(world).collisions) {
      if (collision.began) {
        began.push_back(collision.bodies);
      }
    }
  }
  // The gap of 0.5 m on either side and 5 m in 300 steps: walls in turn, 0.5 m then 1 m apart.
  EXPECT_EQ(began, (std::vector<BodyPair>{{0, 1}, {0, 2}, {0, 1}, {0, 2}, {0, 1}}));
}

TEST(World, TheOrderOfTwoBodiesDoesNotMatter) {
  RandomStream random(kSeed, "order of bodies");
  int met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<BodyModel> models{random_body(random, 3), random_body(random, 3)};
    std::vector<BodyState> states{moving(models[0], {-1.2, 0.0, 0.0}, {2.0, 0.0, 0.0}),
                                  moving(models[1], {1.2, 0.1, 0.0}, {-2.0, 0.0, 0.0})};
    for (BodyState& state : states) {
      state.pose.orientation = random_turn(random);
      state.angular_momentum = random_in_cube(random, 1.0);
    }
    World world(models, states, {0.7, 0.0});
    World swapped({models[1], models[0]}, {states[1], states[0]}, {0.7, 0.0});
    for (int step = 0; step < 200; ++step) {
      const StepReport report = step_whole(world);
      met += report.collisions.empty() ? 0 : 1;
      step_whole(swapped);
    }
    for (std::size_t body = 0; body < 2; ++body) {
      const BodyState& one = world.states()[body];
      const BodyState& other = swapped.states()[1 - body];
      // The sums over node pairs round in another order; an impact's error then grows for 200
      // steps.
      EXPECT_LT((one.pose.position - other.pose.position).norm(), 1e-11) << trial;
      EXPECT_LT((one.linear_momentum - other.linear_momentum).norm(), 1e-11) << trial;
      EXPECT_LT((one.angular_momentum - other.angular_momentum).norm(), 1e-11) << trial;
    }
  }
  EXPECT_GT(met, 100);
}

/// A meter as a live deadline makes it: it grants in slices, and from some total on refuses.
class SlicedWork final : public WorkMeter {
 public:
  SlicedWork(std::int64_t slice, std::int64_t refuse_from)
      : slice_(slice), refuse_from_(refuse_from) {}

  std::int64_t request(std::int64_t total_tests, std::int64_t /*reserved*/) override {
    while (granted_ < total_tests && granted_ < refuse_from_) {
      granted_ += slice_;
    }
    return granted_;
  }

 private:
  std::int64_t slice_;
  std::int64_t refuse_from_;
  std::int64_t granted_{0};
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
      FixedWork logged(shown.work_granted);
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

TEST(World, AStateThatIsNotFiniteIsFlagged) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int field = 0; field < 4; ++field) {
      World world = head_on(2.0, 3.0, 2.0, -1.0);
      BodyState& state = world.mutable_states()[1];
      double* const fields[] = {&state.pose.position.y(), &state.pose.orientation.z(),
                                &state.linear_momentum.z(), &state.angular_momentum.x()};
      *fields[field] = bad;
      EXPECT_TRUE((step_whole(world).degradations & kNotFinite) != 0) << field;
    }
  }
}

TEST(World, AnEmptyWorldSteps) {
  World world({}, {}, {});
  const StepReport report = step_whole(world);
  EXPECT_EQ(report.work_spent, 0);
  EXPECT_EQ(report.degradations, 0U);
}

TEST(World, RefusesWhatItCannotStep) {
  const auto refusal = [](std::vector<BodyModel> models, std::vector<BodyState> states,
                          WorldSettings settings) -> std::string {
    try {
      const World world(std::move(models), std::move(states), settings);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  BodyModel bare;
  EXPECT_EQ(refusal({ball(1.0, 1.0)}, {}, {}), "world: one state per body model is needed");
  EXPECT_EQ(refusal({bare}, {BodyState{}}, {}), "world: every body needs a volume tree");
  EXPECT_EQ(refusal({}, {}, {1.1, 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {-0.1, 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {std::nan(""), 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {1.0, -0.1}), "world: an imposed hold cannot be negative");
}

}  // namespace
}  // namespace impetus
