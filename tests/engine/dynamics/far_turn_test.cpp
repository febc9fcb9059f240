// Bodies that turn far in a step, and needles: their energy, and where they end up.
// SPDX-License-Identifier: MIT
#include "engine/dynamics/motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/engine/builders.hpp"

namespace impetus::far_turn_test {

constexpr std::uint64_t kSeed = 84;

BodyModel block_of(const Vector3& edges_m) {
  BodyModel model = ball(0.5 * edges_m.norm(), 1.0);
  const Vector3 squares = edges_m.cwiseAbs2();
  const Vector3 inertia = (Vector3::Constant(squares.sum()) - squares) / 12.0;
  model.inverse_inertia = inertia.cwiseInverse().asDiagonal();
  return model;
}

BodyState turning(const BodyModel& model, const Vector3& spin_rad_s) {
  BodyState state;
  state.angular_momentum = angular_momentum_at(model, state.pose.orientation, spin_rad_s);
  return state;
}

TEST(FarTurn, SmallStepsOfTheMidpointRuleComeToTheSameOrientation) {
  RandomStream random(kSeed, "against midpoint");
  for (int trial = 0; trial < 30; ++trial) {
    const BodyModel model = random_body(random, 1);
    BodyState state;
    state.pose.orientation = random_turn(random);
    state.angular_momentum = 5.0 * random_direction(random);
    constexpr double kTime_s = 0.5;  // up to 10 radians
    BodyState fine = state;
    constexpr int kSteps = 20'000;
    for (int step = 0; step < kSteps; ++step) {
      advance(model, fine, kTime_s / kSteps);
    }
    // Second order in parts of a fifth of a radian.
    EXPECT_LT(turned_far(model, state, kTime_s).angularDistance(fine.pose.orientation), 0.05)
        << "seed " << kSeed << ", trial " << trial;
  }
}

TEST(FarTurn, ASymmetricTopIsTurnedExactlyHoweverFar) {
  const BodyModel model = block_of({1.0, 1.0, 0.2});
  const BodyState state = turning(model, {30.0, 0.0, 40.0});
  BodyState fine = state;
  constexpr int kSteps = 200'000;
  for (int step = 0; step < kSteps; ++step) {
    advance(model, fine, 1.0 / kSteps);
  }
  EXPECT_LT(turned_far(model, state, 1.0).angularDistance(fine.pose.orientation), 1e-5);
}

TEST(FarTurn, EnergyAndMomentumAreKeptToRoundingAtAnySpinAndInertia) {
  RandomStream random(kSeed, "energies");
  for (const Vector3& edges_m :
       {Vector3(0.2, 0.4, 0.6), Vector3(1.0, 1e-3, 1e-3), Vector3(1.0, 1e-2, 1e-3),
        Vector3(1.0, 1e-4, 2e-4), Vector3(1.0, 1.0, 1e-4), Vector3(1.0, 1.0, 1.0)}) {
    const BodyModel model = block_of(edges_m);
    for (const double spin_rad_s : {300.0, 1e4, 1e6}) {
      BodyState state = turning(model, spin_rad_s * random_direction(random));
      const double start = kinetic_energy(model, state);
      const Vector3 momentum = state.angular_momentum;
      for (int step = 0; step < 200; ++step) {
        advance(model, state, 1.0 / 240.0);
        // What the orientation's rounding makes of the energy of a needle grows with its moments.
        const double ratio = model.inverse_inertia.diagonal().maxCoeff() /
                             model.inverse_inertia.diagonal().minCoeff();
        ASSERT_NEAR(kinetic_energy(model, state) / start, 1.0, 1e-12 * std::max(1e2, ratio))
            << "edges " << edges_m.transpose() << ", spin " << spin_rad_s << ", step " << step;
      }
      EXPECT_EQ(state.angular_momentum, momentum);
      EXPECT_NEAR(state.pose.orientation.norm(), 1.0, 1e-15);
    }
  }
}

TEST(FarTurn, StepsThatTheIterationsTakeWellAreLeftToThem) {
  const BodyModel model = block_of({0.2, 0.4, 0.6});
  EXPECT_FALSE(turns_far(model, turning(model, {5.0, 5.0, 5.0}), 1.0 / 240.0));
  EXPECT_TRUE(turns_far(model, turning(model, {500.0, 0.0, 0.0}), 1.0 / 240.0));
  const BodyModel round = block_of({1.0, 1.0, 1.0});
  EXPECT_FALSE(turns_far(round, turning(round, {500.0, 0.0, 0.0}), 1.0 / 240.0));
}

// What is kept of one body's inertia is of no other.
TEST(FarTurn, IsTheSameWhoeverWasTurnedBefore) {
  RandomStream random(kSeed, "many bodies");
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  std::vector<Quaternion> alone;
  for (int body = 0; body < 100; ++body) {
    models.push_back(random_body(random, 1));
    states.emplace_back().angular_momentum = 5.0 * random_direction(random);
    alone.push_back(turned_far(models.back(), states.back(), 0.5));
  }
  for (int trial = 0; trial < 1'000; ++trial) {
    const std::size_t body = random.below(100);
    ASSERT_EQ(turned_far(models[body], states[body], 0.5).coeffs(), alone[body].coeffs());
  }
}

}  // namespace impetus::far_turn_test
