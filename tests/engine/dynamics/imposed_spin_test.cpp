// The imposed spin: once, at the first response, at its level, and nothing but spin.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "engine/world/world.hpp"
#include "tests/engine/head_on.hpp"

namespace impetus::imposed_spin_test {

const ImposedSpin kSpin{{1.0, -2.0, 3.0}, {-0.5, 0.25, 4.0}};

WorldSettings spun_at(int level) {
  WorldSettings settings;
  settings.imposed_spin = ImposedSpinRule{level, kSpin};
  return settings;
}

Vector3 spin_of(const World& world, std::size_t body) {
  return angular_velocity(world.models()[body], world.states()[body]);
}

TEST(ImposedSpin, IsAddedWhenTheTwoFirstRespondToEachOther) {
  World world = head_on(2.0, 3.0, 2.0, -1.0, spun_at(0));
  const Vector3 turning(0.5, 0.0, 0.0);
  BodyState& a = world.mutable_states()[0];
  a.angular_momentum = angular_momentum_at(world.models()[0], a.pose.orientation, turning);
  const StepReport report = step_whole(world);
  ASSERT_EQ(report.collisions.size(), 1U);
  EXPECT_TRUE(report.collisions[0].imposed_spin);
  // Rounding of an inertia and its inverse.
  EXPECT_LT((spin_of(world, 0) - turning - kSpin.a).norm(), 1e-12);
  EXPECT_LT((spin_of(world, 1) - kSpin.b).norm(), 1e-12);
}

TEST(ImposedSpin, ChangesNoVelocityAndNoPlace) {
  World spun = head_on(2.0, 3.0, 1.0, -1.0, spun_at(0));
  World plain = head_on(2.0, 3.0, 1.0, -1.0);
  for (int step = 0; step < 5; ++step) {
    step_whole(spun);
    step_whole(plain);
    for (std::size_t body = 0; body < 2; ++body) {
      EXPECT_EQ(spun.states()[body].linear_momentum, plain.states()[body].linear_momentum);
      EXPECT_EQ(spun.states()[body].pose.position, plain.states()[body].pose.position);
    }
  }
  EXPECT_NE(hash_state(spun.states()).hash, hash_state(plain.states()).hash);
}

TEST(ImposedSpin, IsGivenOnceThoughTheyMeetAgain) {
  World world = head_on(2.0, 3.0, 2.0, -1.0, spun_at(0));
  step_whole(world);
  for (BodyState& state : world.mutable_states()) {
    state.linear_momentum = -state.linear_momentum;
  }
  int met = 0;
  for (int step = 0; step < 4; ++step) {
    for (const CollisionReport& collision : step_whole(world).collisions) {
      met += collision.impulse_Ns > 0.0 ? 1 : 0;
      EXPECT_FALSE(collision.imposed_spin);
    }
  }
  EXPECT_GT(met, 0);
  EXPECT_LT((spin_of(world, 1) - kSpin.b).norm(), 1e-12);
}

TEST(ImposedSpin, OfAnotherLevelLeavesEveryBitAsItIs) {
  World other = head_on(2.0, 3.0, 2.0, -1.0, spun_at(1));
  World plain = head_on(2.0, 3.0, 2.0, -1.0);
  for (int step = 0; step < 5; ++step) {
    const StepReport report = step_whole(other);
    EXPECT_EQ(report.state.hash, step_whole(plain).state.hash);
    for (const CollisionReport& collision : report.collisions) {
      EXPECT_FALSE(collision.imposed_spin);
    }
  }
}

TEST(ImposedSpin, ThatIsNoNumberIsRefused) {
  WorldSettings settings = spun_at(0);
  settings.imposed_spin->spin.b.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(problem_of(settings), "world: an imposed spin must be finite");
}

}  // namespace impetus::imposed_spin_test
