// Dynamics: free motion and single impulses.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/motion.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/tumbling_box.hpp"

namespace impetus::dynamics_test {

double worst_energy_drift(const BodyModel& model, BodyState state, int steps, double dt_s) {
  const double start = kinetic_energy(model, state);
  double worst = 0.0;
  for (int step = 0; step < steps; ++step) {
    advance(model, state, dt_s);
    worst = std::max(worst, std::fabs(kinetic_energy(model, state) / start - 1.0));
  }
  return worst;
}

TEST(Motion, TumblingAboutTheIntermediateAxisKeepsItsEnergy) {
  const BodyModel model = box_body();
  const double drift = worst_energy_drift(model, tumbling(model, 5.0), 20'000, 0.005);
  RecordProperty("drift", std::to_string(drift * 1e5) + "e-5");
  EXPECT_LT(drift, 5e-5);  // a prototype of the method had 1.8e-5 (engine-notes)
}

TEST(Motion, WhatTurnsAboutOneAxisAloneHasMomentumAboutThatAlone) {
  BodyModel wheel = box_body();
  wheel.inverse_inertia = Vector3(0.0, 0.0, 4.0).asDiagonal();
  const Quaternion lying(std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0);  // its z along the world's −y
  const Vector3 momentum = angular_momentum_at(wheel, lying, {1.0, 2.0, 3.0});
  EXPECT_LT((momentum - Vector3(0.0, 0.5, 0.0)).norm(), 1e-12) << momentum.transpose();
}

TEST(Motion, TheIntermediateAxisIsUnstableAsItShouldBe) {
  const BodyModel model = box_body();
  BodyState state = tumbling(model, 5.0);
  double least = 1.0;
  for (int step = 0; step < 4'000; ++step) {
    advance(model, state, 0.005);
    least = std::min(least, (state.pose.orientation * Vector3::UnitY()).y());
  }
  EXPECT_LT(least, -0.9) << "it never turned over";
}

TEST(Motion, LeavesBothMomentaUntouched) {
  RandomStream random(31, "motion");
  const BodyModel model = random_body(random, 3);
  BodyState state = moving(model, Vector3::Zero(), random_in_cube(random, 3.0));
  state.angular_momentum = random_in_cube(random, 5.0);
  const BodyState start = state;
  for (int step = 0; step < 1'000; ++step) {
    advance(model, state, 0.01);
  }
  EXPECT_EQ(state.linear_momentum, start.linear_momentum);
  EXPECT_EQ(state.angular_momentum, start.angular_momentum);
  EXPECT_NEAR(state.pose.orientation.norm(), 1.0, 1e-15);
}

TEST(Motion, ABallTurnsByItsAngleAroundItsAxis) {
  const BodyModel model = ball(0.5, 2.0);
  BodyState state;
  state.angular_momentum = Vector3(0.0, 0.0, 1.0 / model.inverse_inertia(2, 2));  // 1 rad/s
  for (int step = 0; step < 1'000; ++step) {
    advance(model, state, 0.001);
  }
  // The Cayley map turns by 2 atan(½ ω dt): too little by (ω dt)³/12 a step, 8e-8 over 1 s.
  const Vector3 x_axis = state.pose.orientation * Vector3::UnitX();
  EXPECT_NEAR(std::atan2(x_axis.y(), x_axis.x()), 1.0, 1e-7);
  EXPECT_EQ(x_axis.z(), 0.0);
}

TEST(Motion, ReturnsTheDistanceTheCentreMoved) {
  const BodyModel model = ball(0.5, 2.0);
  BodyState state = moving(model, Vector3::Zero(), Vector3(3.0, 0.0, 4.0));
  EXPECT_DOUBLE_EQ(advance(model, state, 0.1), 0.5);
}

TEST(Motion, ABodyWithoutSpinKeepsItsOrientationBits) {
  RandomStream random(32, "no spin");
  const BodyModel model = random_body(random, 1);
  BodyState state = moving(model, Vector3::Zero(), Vector3::UnitX());
  state.pose.orientation = random_turn(random);
  const Quaternion start = state.pose.orientation;
  advance(model, state, 0.01);
  EXPECT_EQ(state.pose.orientation.coeffs(), start.coeffs());
}

TEST(Motion, StaticBodiesDoNotMoveWhateverTheirMomentum) {
  const BodyModel model = fixed_ball(1.0);
  BodyState state = resting_at({1.0, 2.0, 3.0});
  state.linear_momentum = Vector3(5.0, 5.0, 5.0);
  state.angular_momentum = Vector3(5.0, 5.0, 5.0);
  EXPECT_EQ(advance(model, state, 0.1), 0.0);
  EXPECT_EQ(state.pose.position, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(state.pose.orientation.coeffs(), Quaternion::Identity().coeffs());
}

TEST(Motion, AHoldDelaysTheMotionByItsOwnLength) {
  const BodyModel model = ball(0.5, 2.0);
  BodyState state = moving(model, Vector3::Zero(), Vector3::UnitX());
  state.held_s = 0.025;
  // Steps of 10 ms: two held whole, half of the third, then free.
  const std::array<double, 4> expected_m{0.0, 0.0, 0.005, 0.015};
  const std::array<double, 4> expected_fraction{1.0, 1.0, 0.5, 0.0};
  for (std::size_t step = 0; step < expected_m.size(); ++step) {
    advance(model, state, 0.01);
    EXPECT_NEAR(state.pose.position.x(), expected_m[step], 1e-17);
    EXPECT_NEAR(state.held_fraction, expected_fraction[step], 1e-15);
  }
  EXPECT_EQ(state.held_s, 0.0);
}

TEST(Between, ShowsTheStillPartOfAStepInWhichAHoldEnds) {
  const BodyModel model = ball(0.5, 2.0);
  BodyState after = moving(model, Vector3::Zero(), Vector3::UnitX());
  after.angular_momentum = Vector3(0.0, 0.0, 1.0);
  after.held_s = 0.005;
  const BodyState before = after;
  advance(model, after, 0.01);
  ASSERT_EQ(after.held_fraction, 0.5);
  for (const double fraction : {0.0, 0.25, 0.5}) {
    EXPECT_EQ(between(before, after, fraction).position, before.pose.position) << fraction;
    EXPECT_EQ(between(before, after, fraction).orientation.coeffs(),
              before.pose.orientation.coeffs());
  }
  EXPECT_NEAR(between(before, after, 0.75).position.x(), 0.0025, 1e-17);
  EXPECT_EQ(between(before, after, 1.0).position, after.pose.position);
  EXPECT_LT(between(before, after, 1.0).orientation.angularDistance(after.pose.orientation), 1e-15);
}

TEST(Between, AStepHeldWholeShowsNoMotion) {
  const BodyModel model = ball(0.5, 2.0);
  BodyState after = moving(model, Vector3::Zero(), Vector3::UnitX());
  after.held_s = 1.0;
  const BodyState before = after;
  advance(model, after, 0.01);
  for (const double fraction : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(between(before, after, fraction).position, before.pose.position);
  }
}

TEST(Body, EnergyIsHalfMassTimesSpeedSquaredPlusTheSpin) {
  const BodyModel model = ball(0.5, 2.0);  // 2/5 m r² = 0.2 kg m²
  BodyState state = moving(model, Vector3::Zero(), Vector3(0.0, 3.0, 0.0));
  state.angular_momentum = Vector3(0.4, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(kinetic_energy(model, state), 0.5 * 2.0 * 9.0 + 0.5 * 0.4 * 0.4 / 0.2);
  EXPECT_DOUBLE_EQ(angular_velocity(model, state).x(), 2.0);
}

/// A contact of two bodies of random shape and motion, somewhere near both.
struct RandomImpact {
  explicit RandomImpact(RandomStream& random) {
    for (int body = 0; body < 2; ++body) {
      models.push_back(random_body(random, 1));
      BodyState state =
          moving(models.back(), random_in_cube(random, 1.0), random_in_cube(random, 2.0));
      state.pose.orientation = random_turn(random);
      state.angular_momentum = random_in_cube(random, 1.0);
      states.push_back(state);
    }
    contact.bodies = {0, 1};
    contact.touch.point = random_in_cube(random, 1.0);
    contact.touch.normal = random_direction(random);
  }

  [[nodiscard]] double energy() const {
    return kinetic_energy(models[0], states[0]) + kinetic_energy(models[1], states[1]);
  }

  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  Contact contact;
};

TEST(Respond, OneImpactReversesItsSpeedByTheRestitution) {
  // v⁺ = −ε v⁻ and ΔE = ½ (1 − ε) j v⁻
  RandomStream random(33, "impacts");
  for (int trial = 0; trial < 2'000; ++trial) {
    RandomImpact impact(random);
    const double restitution = random.uniform();
    const double before = separation_speed(impact.contact, impact.models, impact.states);
    const double energy = impact.energy();
    const ResponseResult result =
        respond({impact.contact}, restitution, impact.models, impact.states);
    const double after = separation_speed(impact.contact, impact.models, impact.states);
    if (before >= 0.0) {
      EXPECT_EQ(result.impulse_Ns[0], 0.0);
      EXPECT_EQ(after, before);
      continue;
    }
    EXPECT_EQ(result.approach_m_s[0], -before);
    // Some 30 roundings of numbers below 20.
    EXPECT_NEAR(after, -restitution * before, 1e-13);
    EXPECT_NEAR(impact.energy() - energy, 0.5 * (1.0 - restitution) * result.impulse_Ns[0] * before,
                1e-13 * energy);
  }
}

TEST(NetContact, IsTheSumsDirectionAtTheMeanPlaceAndHasNoDepth) {
  const std::vector<Contact> contacts{{{0, 1}, {{0.0, 0.0, 0.0}, Vector3::UnitX(), 0.1}},
                                      {{0, 1}, {{4.0, 0.0, 0.0}, Vector3::UnitY(), 0.2}}};
  const TouchPoint net = net_contact(contacts, {4.0, 3.0});
  EXPECT_LT((net.normal - Vector3(0.8, 0.6, 0.0)).norm(), 1e-15);
  EXPECT_LT((net.point - Vector3(12.0 / 7.0, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_EQ(net.depth_m, 0.0);
  EXPECT_EQ(net_contact(contacts, {0.0, 0.0}).depth_m, 0.2) << "the deepest, of no impulse";
}

TEST(Respond, MomentumAndAngularMomentumArePassedOnNotMade) {
  RandomStream random(34, "momenta");
  for (int trial = 0; trial < 500; ++trial) {
    RandomImpact impact(random);
    const auto totals = [&impact] {
      Vector3 linear = Vector3::Zero();
      Vector3 angular = Vector3::Zero();
      for (const BodyState& state : impact.states) {
        linear += state.linear_momentum;
        angular += state.angular_momentum + state.pose.position.cross(state.linear_momentum);
      }
      return std::pair(linear, angular);
    };
    const auto before = totals();
    respond({impact.contact}, 0.7, impact.models, impact.states);
    EXPECT_LT((totals().first - before.first).norm(), 1e-14);
    EXPECT_LT((totals().second - before.second).norm(), 1e-13);
  }
}

TEST(Respond, NothingIsLeftApproachingAfterOneContact) {
  RandomStream random(35, "residual");
  for (int trial = 0; trial < 5'000; ++trial) {
    RandomImpact impact(random);
    const ResponseResult result = respond({impact.contact}, 0.0, impact.models, impact.states);
    // Rounding leaves some 1e-14 of the speed, which is not an approach (kNegligibleApproach).
    EXPECT_EQ(result.residual_approach_m_s, 0.0) << trial;
    EXPECT_GE(separation_speed(impact.contact, impact.models, impact.states), -1e-13) << trial;
  }
}

TEST(Respond, AnApproachThatThePassesLeaveIsReported) {
  // A ball falls into a steep wedge: each wall's impulse drives it .28 as fast into the other, and
  // five passes leave about .28^10.
  const std::vector<BodyModel> models{ball(0.5, 1.0), fixed_ball(0.5), fixed_ball(0.5)};
  std::vector<BodyState> states{moving(models[0], Vector3::Zero(), {0.0, -1.0, 0.0}),
                                resting_at({0.8, -0.6, 0.0}), resting_at({-0.8, -0.6, 0.0})};
  std::vector<Contact> contacts(2);
  contacts[0].bodies = {0, 1};
  contacts[0].touch = {{0.4, -0.3, 0.0}, {-0.8, 0.6, 0.0}, 0.0};
  contacts[1].bodies = {0, 2};
  contacts[1].touch = {{-0.4, -0.3, 0.0}, {0.8, 0.6, 0.0}, 0.0};
  const ResponseResult result = respond(contacts, 0.0, models, states);
  double left = 0.0;
  for (const Contact& contact : contacts) {
    left = std::max(left, -separation_speed(contact, models, states));
  }
  EXPECT_GT(left, 1e-9);
  EXPECT_EQ(result.residual_approach_m_s, left);
}

TEST(Respond, ManyContactsOfOnePairNeverAddEnergy) {
  RandomStream random(36, "many contacts");
  for (int trial = 0; trial < 2'000; ++trial) {
    RandomImpact impact(random);
    std::vector<Contact> contacts;
    for (int i = 0; i < 6; ++i) {
      Contact contact = impact.contact;
      contact.touch.point = random_in_cube(random, 1.0);
      contact.touch.normal = random_direction(random);
      contacts.push_back(contact);
    }
    const double before = impact.energy();
    respond(contacts, random.uniform(), impact.models, impact.states);
    EXPECT_LE(impact.energy(), before * (1.0 + 1e-13)) << trial;
  }
}

TEST(Respond, StaticBodiesKeepTheirMomentaAndTheOtherBouncesOff) {
  const std::vector<BodyModel> models{fixed_ball(1.0), ball(0.5, 2.0)};
  std::vector<BodyState> states{resting_at(Vector3::Zero()),
                                moving(models[1], {1.5, 0.0, 0.0}, {-4.0, 1.0, 0.0})};
  Contact contact;
  contact.bodies = {0, 1};
  contact.touch = {{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 0.0};
  respond({contact}, 0.5, models, states);
  EXPECT_EQ(states[0].linear_momentum, Vector3::Zero());
  EXPECT_EQ(velocity(models[1], states[1]), Vector3(2.0, 1.0, 0.0));
}

TEST(Respond, TwoStaticBodiesInContactAreLeftAlone) {
  const std::vector<BodyModel> models{fixed_ball(1.0), fixed_ball(1.0)};
  std::vector<BodyState> states(2);
  Contact contact;
  contact.bodies = {0, 1};
  const ResponseResult result = respond({contact}, 1.0, models, states);
  EXPECT_EQ(result.impulse_Ns[0], 0.0);
  EXPECT_EQ(result.residual_approach_m_s, 0.0);
}

}  // namespace impetus::dynamics_test
