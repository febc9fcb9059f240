// The two ways to step a rotation: what each keeps, and for how long.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/dynamics/motion.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/tumbling_box.hpp"

namespace impetus::rotation_test {

constexpr std::uint64_t kSeed = 66;

double worst_drift(BodyState state, double dt_s, int steps, Rotation rotation) {
  const BodyModel model = box_body();
  const Vector3 momentum = state.angular_momentum;
  const double start = kinetic_energy(model, state);
  double worst = 0.0;
  for (int step = 0; step < steps; ++step) {
    advance(model, state, dt_s, rotation);
    worst = std::max(worst, std::abs(kinetic_energy(model, state) / start - 1.0));
  }
  EXPECT_EQ(state.angular_momentum, momentum) << "exactly";
  return worst;
}

TEST(Rotation, TheIntermediateAxisDriftsByLessThanTwoHundredThousandths) {
  for (const double spin : {0.5, 1.0, 2.0, 5.0}) {
    const BodyState state = tumbling(box_body(), spin);
    EXPECT_LT(worst_drift(state, 0.01, 20'000, Rotation::kEnergyKept), 1e-13) << spin;
  }
  // The midpoint rule keeps to it up to 2 rad/s; its error grows with the square of the turn of a
  // step, swings, and does not accumulate.
  for (const double spin : {0.5, 1.0, 2.0}) {
    const BodyState state = tumbling(box_body(), spin);
    EXPECT_LT(worst_drift(state, 0.01, 20'000, Rotation::kMidpoint), 2e-5) << spin;
  }
  const BodyState fast = tumbling(box_body(), 5.0);
  EXPECT_LT(worst_drift(fast, 0.01, 20'000, Rotation::kMidpoint), 8e-5);
}

TEST(Rotation, BothWaysTurnOverAtTheSameTime) {
  const BodyModel model = box_body();
  for (const double spin : {1.0, 5.0}) {
    BodyState kept = tumbling(model, spin);
    BodyState middle = kept;
    double farthest = 0.0;
    for (int step = 0; step < 4'000; ++step) {
      advance(model, kept, 0.002, Rotation::kEnergyKept);
      advance(model, middle, 0.002, Rotation::kMidpoint);
      farthest = std::max(farthest, kept.pose.orientation.angularDistance(middle.pose.orientation));
    }
    EXPECT_GT(farthest, 0.0);
    EXPECT_LT(farthest, 0.05) << "two methods of the second order, 8 s";
  }
}

// Halving the step of a method of the second order quarters its error.
TEST(Rotation, KeepingTheEnergyIsOfTheSecondOrder) {
  RandomStream random(kSeed, "order");
  for (int trial = 0; trial < 20; ++trial) {
    const BodyModel model = random_body(random, 1);
    BodyState start;
    start.pose.orientation = random_turn(random);
    start.angular_momentum = random_in_cube(random, 0.5);
    const auto after_one_second = [&](int steps) {
      BodyState state = start;
      for (int step = 0; step < steps; ++step) {
        advance(model, state, 1.0 / steps, Rotation::kEnergyKept);
      }
      return state.pose.orientation;
    };
    const Quaternion exact = after_one_second(8'192);
    const double coarse = after_one_second(64).angularDistance(exact);
    const double fine = after_one_second(128).angularDistance(exact);
    EXPECT_NEAR(coarse / fine, 4.0, 0.2) << "seed " << kSeed << ", trial " << trial;
  }
}

TEST(Rotation, AnyTurnGivesAUnitQuaternionAndKeepsTheMomentum) {
  RandomStream random(kSeed, "wild");
  for (int trial = 0; trial < 500; ++trial) {
    const BodyModel model = random_body(random, 1);
    BodyState state;
    state.pose.orientation = random_turn(random);
    state.angular_momentum =
        std::ldexp(1.0, static_cast<int>(random.below(60)) - 30) * random_direction(random);
    const Vector3 momentum = state.angular_momentum;
    for (int step = 0; step < 10; ++step) {
      advance(model, state, 0.1, Rotation::kEnergyKept);
    }
    EXPECT_NEAR(state.pose.orientation.norm(), 1.0, 1e-14);
    EXPECT_EQ(state.angular_momentum, momentum);
  }
}

TEST(Rotation, AWorldThatKeepsEnergyKeepsItToRoundingWhileBodiesTumbleAndMeet) {
  WorldSettings settings;
  settings.rotation = Rotation::kEnergyKept;
  World world = random_tree_world(5, 3, settings);
  const double start = total_energy(world);
  std::size_t met = 0;
  for (int step = 0; step < 500; ++step) {
    met += step_whole(world).collisions.size();
  }
  EXPECT_GT(met, 5U);
  EXPECT_NEAR(total_energy(world) / start, 1.0, 1e-11) << "restitution 1";
}

}  // namespace impetus::rotation_test
