// World: the step as physics, and what it refuses.
// SPDX-License-Identifier: MIT
#include "engine/world/world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "engine/dynamics/motion.hpp"
#include "tests/engine/head_on.hpp"

namespace impetus::world_test {

constexpr std::uint64_t kSeed = 1'637;
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

TEST(World, WhatPassesThroughTouchesNeitherBodiesNorWalls) {
  for (const std::size_t ghost : {0U, 1U}) {
    std::vector<BodyModel> models{ball(0.5, 1.0), ball(0.5, 1.0)};
    models[ghost].passes_through = true;
    WorldSettings settings;
    settings.enclosure = ClosedCube{3.0};
    World world(models,
                {moving(models[0], {-0.8, 0.0, 0.0}, {3.0, 0.0, 0.0}),
                 moving(models[1], {0.8, 0.0, 0.0}, {0.0, 0.0, 0.0})},
                settings);
    bool has_touched = false;
    for (int step = 0; step < 480; ++step) {
      for (const CollisionReport& collision : step_whole(world).collisions) {
        ASSERT_TRUE(is_wall(collision.bodies.b)) << "step " << step;
        ASSERT_EQ(collision.bodies.a, static_cast<std::int32_t>(1 - ghost));
        has_touched = true;
      }
    }
    EXPECT_EQ(has_touched, ghost == 1U) << "the one that moves meets a wall, or passes it, too";
    EXPECT_EQ(x_speed(world, 1), 0.0);
    EXPECT_EQ(std::abs(x_speed(world, 0)), 3.0);
  }
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
  EXPECT_EQ(refusal({bare}, {BodyState{}}, {}),
            "world: body 0 \"\": expected a volume tree, got none");
  EXPECT_EQ(refusal({}, {}, {1.1, 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {-0.1, 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {std::nan(""), 0.0}), "world: restitution must lie in [0, 1]");
  EXPECT_EQ(refusal({}, {}, {1.0, -0.1}), "world: an imposed hold cannot be negative");
}

}  // namespace impetus::world_test
