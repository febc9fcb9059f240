// The imposed rebound: once, at the first response, wider or narrower, faster or slower.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/world/world.hpp"
#include "tests/engine/head_on.hpp"

namespace impetus::imposed_rebound_test {

WorldSettings with_rebound(double wider_deg, double speed_ratio) {
  WorldSettings settings;
  settings.imposed_rebound = ImposedRebound{wider_deg, Vector3::UnitZ(), speed_ratio};
  return settings;
}

/// Equal balls of 1 m, the second at rest, hit 45° off its centre: they part at a right angle.
World off_centre(const WorldSettings& settings) {
  const std::vector<BodyModel> models{ball(0.5, 1.0), ball(0.5, 1.0)};
  const double aside_m = std::sqrt(0.5);
  return {models,
          {moving(models[0], Vector3(-aside_m - 0.5 * kStep_s, -aside_m, 0.0), {1.0, 0.0, 0.0}),
           moving(models[1], Vector3::Zero(), Vector3::Zero())},
          settings};
}

Vector3 velocity_of(const World& world, std::size_t body) {
  return velocity(world.models()[body], world.states()[body]);
}

double angle_between_deg(const World& world) {
  const Vector3 a = velocity_of(world, 0);
  const Vector3 b = velocity_of(world, 1);
  return degrees(atan2_rad(a.cross(b).norm(), a.dot(b)));
}

World parted(const WorldSettings& settings) {
  World world = off_centre(settings);
  step_whole(world);
  return world;
}

TEST(ImposedRebound, PartsThemWiderByHalfOfItEach) {
  const World plain = parted({});
  ASSERT_NEAR(angle_between_deg(plain), 90.0, 0.2);  // they met within a step
  const World wider = parted(with_rebound(30.0, 1.0));
  EXPECT_NEAR(angle_between_deg(wider) - angle_between_deg(plain), 30.0, 1e-9);
  for (std::size_t body = 0; body < 2; ++body) {
    const Vector3 was = velocity_of(plain, body);
    const Vector3 is = velocity_of(wider, body);
    EXPECT_NEAR(is.norm(), was.norm(), 1e-12);
    EXPECT_NEAR(degrees(atan2_rad(was.cross(is).norm(), was.dot(is))), 15.0, 1e-9);
  }
}

TEST(ImposedRebound, PartsThemNarrower) {
  const double plain = angle_between_deg(parted({}));
  EXPECT_NEAR(angle_between_deg(parted(with_rebound(-50.0, 1.0))), plain - 50.0, 1e-9);
}

TEST(ImposedRebound, IsTheSameWhicheverSideTheFirstComesFrom) {
  const auto mirrored = [](const WorldSettings& settings) {
    World world = off_centre(settings);
    world.mutable_states()[0].pose.position.y() *= -1.0;
    step_whole(world);
    return angle_between_deg(world);
  };
  EXPECT_NEAR(mirrored(with_rebound(30.0, 1.0)) - mirrored({}), 30.0, 1e-9);
}

TEST(ImposedRebound, ChangesTheSpeedOfBoth) {
  const World plain = parted({});
  const World slower = parted(with_rebound(0.0, 0.25));
  for (std::size_t body = 0; body < 2; ++body) {
    EXPECT_LT((velocity_of(slower, body) - 0.25 * velocity_of(plain, body)).norm(), 1e-12);
  }
}

TEST(ImposedRebound, IsGivenOnceThoughTheyMeetAgain) {
  World world = head_on(1.0, 1.0, 1.0, -1.0, with_rebound(0.0, 2.0));
  step_whole(world);
  EXPECT_NEAR(x_speed(world, 1), 2.0, 1e-12);
  for (BodyState& state : world.mutable_states()) {
    state.linear_momentum = -state.linear_momentum;
  }
  for (int step = 0; step < 4; ++step) {
    step_whole(world);
  }
  EXPECT_NEAR(x_speed(world, 1), 2.0, 1e-12) << "back again, as physics has it";
}

TEST(ImposedRebound, ThatCannotBeIsRefused) {
  EXPECT_EQ(problem_of(with_rebound(361.0, 1.0)),
            "world: an imposed rebound turns by 360 degrees at most");
  EXPECT_EQ(problem_of(with_rebound(0.0, -0.5)),
            "world: the speed ratio of an imposed rebound cannot be negative, and must be finite");
  WorldSettings long_axis = with_rebound(10.0, 1.0);
  long_axis.imposed_rebound->axis *= 2.0;
  EXPECT_EQ(problem_of(long_axis), "world: the axis of an imposed rebound must be a unit vector");
}

}  // namespace impetus::imposed_rebound_test
