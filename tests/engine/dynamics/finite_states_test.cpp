// Bodies whose state is not finite: named in the step, put back, out for good, and nobody else's
// concern.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "engine/dynamics/limits.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::finite_states_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Three balls in a row: the first flies at the second, the third stands by.
World row_of_balls() {
  const BodyModel model = ball(0.5, 1.0);
  return {{model, model, model},
          {moving(model, {-1.5, 0.0, 0.0}, {1.0, 0.0, 0.0}), resting_at({0.0, 0.0, 0.0}),
           resting_at({5.0, 0.0, 0.0})},
          {}};
}

TEST(FiniteStates, TheBodyAndTheFieldAreNamedInTheStepAndTheBodyIsPutBackWithoutMomentum) {
  for (const double bad : {kNan, kInfinite, -kInfinite, 1e101}) {
    for (int field = 0; field < 4; ++field) {
      World world = row_of_balls();
      step_whole(world);
      BodyState& state = world.mutable_states()[0];
      const Pose before = state.pose;
      double* const numbers[] = {&state.pose.position.y(), &state.pose.orientation.z(),
                                 &state.linear_momentum.z(), &state.angular_momentum.x()};
      *numbers[field] = bad;
      const StepReport report = step_whole(world);
      const std::vector<NotFiniteBody> expected{{0, static_cast<StateField>(field)}};
      EXPECT_EQ(report.not_finite, expected) << bad;
      EXPECT_NE(report.degradations & kNotFinite, 0U);
      const BodyState& after = world.states()[0];
      EXPECT_LT((after.pose.position - before.position).norm(), 0.01) << "a step's way";
      EXPECT_EQ(after.pose.orientation.coeffs(), before.orientation.coeffs());
      EXPECT_TRUE(after.linear_momentum.isZero(0.0));
      EXPECT_TRUE(after.angular_momentum.isZero(0.0));
    }
  }
}

TEST(FiniteStates, ABodyThatIsOutTouchesNobodyAndIsNamedOnce) {
  World world = row_of_balls();
  world.mutable_states()[0].linear_momentum.x() = kNan;
  const Vector3 place = world.states()[0].pose.position;
  EXPECT_EQ(step_whole(world).not_finite.size(), 1U);
  world.mutable_states()[1].linear_momentum.x() = -1.0;  // through where the first one stands
  for (int step = 0; step < 1'000; ++step) {
    const StepReport report = step_whole(world);
    ASSERT_TRUE(report.not_finite.empty());
    ASSERT_TRUE(report.collisions.empty());
    ASSERT_NE(report.degradations & kNotFinite, 0U) << "the world is still short of it";
  }
  EXPECT_EQ(world.states()[0].pose.position, place);
  EXPECT_EQ(world.states()[1].linear_momentum.x(), -1.0);
  world.mutable_states()[0].pose.position.x() = kNan;
  EXPECT_TRUE(step_whole(world).not_finite.empty());
  EXPECT_EQ(world.states()[0].pose.position, place);
}

TEST(FiniteStates, GravityAndWallsLeaveABodyAloneThatIsOut) {
  WorldSettings settings;
  settings.gravity_m_s2 = {0.0, -9.81, 0.0};
  settings.enclosure = ClosedCube{1.0};
  World world({ball(0.5, 1.0)}, {resting_at({0.0, -0.5, 0.0})}, settings);
  world.mutable_states()[0].angular_momentum.z() = kInfinite;
  for (int step = 0; step < 240; ++step) {
    ASSERT_TRUE(step_whole(world).collisions.empty());
  }
  EXPECT_EQ(world.states()[0].pose.position, Vector3(0.0, -0.5, 0.0));
  EXPECT_TRUE(world.states()[0].linear_momentum.isZero(0.0));
}

TEST(FiniteStates, ACopyOfTheWorldKnowsWhoIsOut) {
  World world = row_of_balls();
  world.mutable_states()[0].linear_momentum.x() = kNan;
  step_whole(world);
  World copy = world;
  for (int step = 0; step < 500; ++step) {
    ASSERT_EQ(step_whole(copy).state.hash, step_whole(world).state.hash);
  }
  EXPECT_EQ(copy.states()[0].pose.position, row_of_balls().states()[0].pose.position);
}

TEST(FiniteStates, AMomentumAsGreatAsItMayBeStaysFiniteThroughACollision) {
  World world = row_of_balls();
  world.mutable_states()[0].linear_momentum.x() = 0.5 * kMostNumber;
  const StepReport report = step_whole(world, 1e-3);
  EXPECT_TRUE(report.not_finite.empty());
  EXPECT_FALSE(not_finite_field(world.states()[0]));
  EXPECT_FALSE(not_finite_field(world.states()[1]));
}

TEST(FiniteStates, WorldsAreRefusedThatCannotBeStepped) {
  const auto refused = [](const BodyModel& model, const BodyState& state) {
    return problem_of({model}, {state});
  };
  const BodyModel model = ball(0.5, 1.0);
  const std::string body = "world: body 0 \"ball\": expected ";
  EXPECT_EQ(refused(model, resting_at({0.0, kNan, 1.0})),
            body + "a position of finite numbers, got (0.000000, nan, 1.000000)");
  BodyState state;
  state.angular_momentum.x() = kInfinite;
  EXPECT_EQ(refused(model, state),
            body + "an angular momentum of finite numbers, got (inf, 0.000000, 0.000000)");
  state = {};
  state.pose.orientation.coeffs().setZero();
  EXPECT_EQ(refused(model, state), body + "an orientation of unit length, got one of 0.000000");
  state.pose.orientation.coeffs() = {0.0, 0.0, 0.0, 1.9};
  EXPECT_EQ(refused(model, state), body + "an orientation of unit length, got one of 1.900000");
  state = {};
  for (const double held_s : {-10.0, kNan, kInfinite}) {
    state.held_s = held_s;
    EXPECT_EQ(refused(model, state), body + "to be held for 0 s or more, a finite number, got " +
                                         std::to_string(held_s) + " s");
  }
  BodyModel heavy = model;
  heavy.inverse_mass = -1.0;
  EXPECT_EQ(refused(heavy, {}),
            body + "an inverse mass of 0 or more, a finite number, got -1.000000 1/kg");
  heavy.inverse_mass = kInfinite;
  EXPECT_EQ(refused(heavy, {}),
            body + "an inverse mass of 0 or more, a finite number, got inf 1/kg");
  BodyModel turning = model;
  turning.inverse_inertia(0, 0) = kNan;
  EXPECT_EQ(refused(turning, {}),
            body +
                "an inverse inertia of finite numbers, those on its diagonal 0 or more, got "
                "another");
  turning = model;
  turning.inverse_inertia(0, 1) = 0.5 * turning.inverse_inertia(0, 0);
  EXPECT_EQ(refused(turning, {}),
            body + "an inverse inertia that equals its transpose, got another");
  turning.inverse_inertia << 1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0;
  EXPECT_EQ(refused(turning, {}),
            body + "an inverse inertia of 0 or more about every axis, got one below 0");
  turning.inverse_inertia = Vector3(0.0, 0.0, 2.0).asDiagonal();  // on an axle
  EXPECT_EQ(refused(turning, {}), "");
  EXPECT_EQ(refused(ball(kInfinite, 1.0), {}),
            body + "a tree of a finite size, got a radius of inf m");
}

TEST(FiniteStates, AStepThatIsNoTimeIsRefused) {
  World world = row_of_balls();
  for (const double step_s : {kNan, kInfinite, -1e-3}) {
    FixedWork meter(kUnlimitedTests);
    try {
      world.step(step_of(step_s), meter);
      FAIL() << step_s;
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), "world: expected a time step of 0 s or more, a finite number");
    }
  }
}

}  // namespace impetus::finite_states_test
