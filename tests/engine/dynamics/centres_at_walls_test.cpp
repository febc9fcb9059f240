// Nobody's centre goes through a wall, however fast, at no cost of energy.
// SPDX-License-Identifier: MIT
#include "engine/dynamics/centres_at_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/world/world.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::centres_at_walls_test {

constexpr std::uint64_t kSeed = 5;

Enclosure what_is_seen() {
  return view_frustum(viewer_at({0.8, 0.6, 1280, 1024, 2.0}, 25.0), 0.4, 0.4);
}

double energy_J(const BodyModel& model, const BodyState& state, const Vector3& gravity_m_s2) {
  return kinetic_energy(model, state) - gravity_m_s2.dot(state.pose.position) / model.inverse_mass;
}

TEST(CentresAtWalls, AWayEndsAtAnyWallsWithTheEnergyThatItBeganWith) {
  RandomStream random(kSeed, "ways");
  const BodyModel model = ball(0.01, 2.0);
  int ended = 0;
  for (const Enclosure& walls : {Enclosure(ClosedCube{0.1}), what_is_seen()}) {
    for (int i = 0; i < 1'000; ++i) {
      const Vector3 gravity = random_in_cube(random, 10.0);
      BodyState before = moving(model, random_in_cube(random, 0.1), random_in_cube(random, 9.0));
      if (beyond_walls_m(walls, before.pose.position) > 0.0) {
        continue;
      }
      BodyState after = before;
      const double dt_s = 0.05;
      advance(model, after, dt_s, Rotation::kMidpoint, {gravity});
      const bool ends = beyond_walls_m(walls, after.pose.position) > 0.0;
      const BodyState free = after;
      keep_centre_inside(walls, gravity, model, before.pose.position, after);
      ASSERT_LE(beyond_walls_m(walls, after.pose.position), wall_rounding_m(model));
      ASSERT_NEAR(energy_J(model, after, gravity), energy_J(model, before, gravity), 1e-12);
      ASSERT_TRUE(ends || after.pose.position == free.pose.position) << "others go on";
      ended += ends ? 1 : 0;
    }
  }
  EXPECT_GT(ended, 500);
}

TEST(CentresAtWalls, TheSpeedIsWhatItWasThere) {
  const BodyModel model = ball(0.01, 2.0);
  const Vector3 gravity(0.0, -10.0, 0.0);
  const Vector3 from(0.0, -0.5, 0.0);
  BodyState state = moving(model, from, {0.5, -1.0, 0.0});
  advance(model, state, 1.0, Rotation::kMidpoint, {gravity});  // by .5 and -6 m
  keep_centre_inside(Enclosure(ClosedCube{1.0}), gravity, model, from, state);
  EXPECT_NEAR(state.pose.position.y(), -1.0, 1e-15);
  EXPECT_NEAR(state.pose.position.x(), 0.5 / 12.0, 1e-15);
  EXPECT_NEAR(velocity(model, state).y(), -std::sqrt(1.0 + 2.0 * 10.0 * 0.5), 1e-12);
  EXPECT_EQ(velocity(model, state).x(), 0.5);
}

TEST(CentresAtWalls, WhoIsBeyondGoesOnAndSoDoesWhoPassesThroughOthers) {
  BodyModel model = ball(0.01, 2.0);
  const Enclosure walls = ClosedCube{1.0};
  const Vector3 none = Vector3::Zero();
  BodyState state = moving(model, {1.5, 0.0, 0.0}, {1.0, 0.0, 0.0});
  keep_centre_inside(walls, none, model, {1.2, 0.0, 0.0}, state);
  EXPECT_EQ(state.pose.position.x(), 1.5);
  keep_centre_inside(walls, none, model, {1.0 + 1e-15, 0.0, 0.0}, state);
  EXPECT_NEAR(state.pose.position.x(), 1.0, 1e-14) << "beyond by rounding is at the wall";
  state.pose.position.x() = 1.5;
  model.passes_through = true;
  keep_centre_inside(walls, none, model, none, state);
  EXPECT_EQ(state.pose.position.x(), 1.5);
  model.passes_through = false;
  keep_centre_inside(walls, none, model, none, state);
  EXPECT_EQ(state.pose.position.x(), 1.0);
}

TEST(CentresAtWalls, ABallThatIsFastForItsRoomStaysInsideAndKeepsItsEnergy) {
  for (const Tunnelling tunnelling : {Tunnelling::kIgnored, Tunnelling::kStopAtEntry}) {
    for (const Enclosure& walls : {Enclosure(ClosedCube{0.1}), what_is_seen()}) {
      WorldSettings settings;
      settings.tunnelling = tunnelling;
      settings.enclosure = walls;
      settings.gravity_m_s2 = {0.0, -9.81, 0.0};
      const BodyModel model = ball(0.004, 0.01);
      World world({model}, {moving(model, Vector3::Zero(), {40.0, -25.0, 31.0})}, settings);
      const double start_J = energy_J(model, world.states()[0], settings.gravity_m_s2);
      FixedWork meter(kUnlimitedTests);
      for (int step = 0; step < 600; ++step) {
        world.step(step_of(1.0 / 60.0), meter);
        const BodyState& state = world.states()[0];
        ASSERT_LE(beyond_walls_m(walls, state.pose.position), wall_rounding_m(model));
        ASSERT_NEAR(energy_J(model, state, settings.gravity_m_s2), start_J, 1e-9 * start_J);
      }
    }
  }
}

}  // namespace impetus::centres_at_walls_test
