// SPDX-License-Identifier: MIT
#include "experiments/run/live_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/trees/volume_tree.hpp"
#include "experiments/session/unattended.hpp"

namespace impetus::playback_test {

/// One ball in a closed cube of 2 m, on its way to the wall at +x.
StagedScene ball_in_a_cube() {
  BodyModel ball;
  ball.name = "ball";
  ball.tree = std::make_shared<const VolumeTree>(single_node_tree(Sphere{Vector3::Zero(), 0.1}));
  ball.inverse_mass = 1.0;
  BodyState state;
  state.linear_momentum = Vector3::UnitX();
  WorldSettings settings;
  settings.enclosure = ClosedCube{1.0};
  StagedScene scene{World({ball}, {state}, settings),
                    viewer_at({0.4, 0.3, 1280, 1024, 0.57}, 0.0),
                    {DrawnBody{"ball", 0.1}}};
  scene.step_hz = 100.0;
  return scene;
}

TEST(LiveRun, ACollisionWithAWallIsRecordedWithThePoseOfTheBodyAlone) {
  LiveRun playback(ball_in_a_cube(), 1);
  playback.poses_at(1.0);
  const std::vector<CollisionRecord> collisions = playback.take_collisions();
  ASSERT_EQ(collisions.size(), 1U);
  EXPECT_TRUE(is_wall(collisions[0].report.bodies.b));
  // 0.9 m to the wall at 1 m/s: step 90, or 91 where rounding left it short of touching.
  EXPECT_NEAR(static_cast<double>(collisions[0].step), 90.0, 1.0);
  EXPECT_NEAR(collisions[0].pose_a.position.x(), 0.9, 0.011);
  EXPECT_EQ(collisions[0].pose_b.position, Vector3::Zero());
}

TEST(LiveRun, ManyStepsAreToldOfHoweverShortTheirTime) {
  StagedScene scene = ball_in_a_cube();
  scene.step_hz = 100'000.0;
  LiveRun playback(std::move(scene), 1);
  std::vector<double> told;
  play_to(playback, /*end_s=*/0.1, [&](double share) { told.push_back(share); });
  EXPECT_EQ(told.size(), 40U);  // 10000 steps, 250 at a time
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

}  // namespace impetus::playback_test
