// The imposed hold: bodies stay where they touched for as long as was asked, then go.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/world/world.hpp"
#include "tests/engine/head_on.hpp"

namespace impetus::imposed_hold_test {

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

}  // namespace impetus::imposed_hold_test
