// Scenes that depend on the view: bodies kept in it by walls, and a viewer who goes round them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/gaze/region_source.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/run/replay.hpp"
#include "tests/experiments/test_scenes.hpp"

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "experiments/drawing/enclosure_painter.hpp"
#endif

namespace impetus::view_test {

json frustum_crowd() {
  json scene = crowd_scene();
  scene["enclosure"] = {{"kind", "view-frustum"}, {"front_deg", 8}, {"back_deg", 12}};
  scene["viewer"]["azimuth_deg"] = 30;
  scene["crowd"]["speed_deg_s"] = 20;
  scene["duration_s"] = 3;
  return scene;
}

TEST(ViewFrustumScene, EachKindOfEnclosureHasItsOwnKeys) {
  EXPECT_EQ(scene_refusal(frustum_crowd()), "accepted");
  json edged = frustum_crowd();
  edged["enclosure"]["edge_deg"] = 5;
  EXPECT_EQ(scene_refusal(edged),
            "/enclosure/edge_deg: expected none for kind view-frustum, got 5");
  json endless = frustum_crowd();
  endless["enclosure"].erase("back_deg");
  EXPECT_EQ(scene_refusal(endless),
            "/enclosure: expected the key \"back_deg\" for kind view-frustum, which is missing");
  json edgeless = crowd_scene();
  edgeless["enclosure"].erase("edge_deg");
  EXPECT_EQ(scene_refusal(edgeless),
            "/enclosure: expected the key \"edge_deg\" for kind closed-cube, which is missing");
  EXPECT_EQ(scene_refusal(changed(crowd_scene(), "/enclosure/kind", "sphere")),
            "/enclosure/kind: expected one of \"closed-cube\", \"view-frustum\", got \"sphere\"");
}

TEST(ViewFrustumScene, ACrowdStartsInViewAndStaysThere) {
  StagedScene scene = built(frustum_crowd());
  FixedWork meter(kUnlimitedTests);
  double nearest_edge = 1.0;
  int walls = 0;
  for (int step = 0; step < 720; ++step) {
    const StepReport report = scene.world.step({1.0 / scene.step_hz, scene.viewer}, meter);
    for (const CollisionReport& collision : report.collisions) {
      walls += is_wall(collision.bodies.b) && collision.began ? 1 : 0;
    }
    for (const BodyState& body : scene.world.states()) {
      const auto seen = projected(scene.viewer, body.pose.position);
      ASSERT_TRUE(seen);
      const double x = std::abs(seen->x_m) / (0.5 * scene.viewer.screen.width_m);
      const double y = std::abs(seen->y_m) / (0.5 * scene.viewer.screen.height_m);
      nearest_edge = std::min(nearest_edge, 1.0 - std::max(x, y));
    }
  }
  EXPECT_GT(walls, 5) << "they have to meet walls for this to be a test";
  EXPECT_GT(nearest_edge, 0.0);
}

TEST(ViewFrustumScene, ItsImageIsTheWholeScreen) {
  const StagedScene scene = built(frustum_crowd());
  const EnclosureImage image(scene.world.settings().enclosure, scene.viewer);
  const EnclosureImage whole(std::nullopt, scene.viewer);
  const GazeRegion region{{0.03, -0.05}, 4.0};
  EXPECT_NEAR(image.covered_share(region), whole.covered_share(region), 1e-9);
}

TEST(ViewFrustumScene, ItsWallsAreNamedAsTheViewerSeesThem) {
  const StagedScene scene = built(frustum_crowd());
  const WallNaming naming = wall_naming(scene.world.settings().enclosure);
  EXPECT_EQ(wall_name(wall_index(0), naming), "wall right");
  EXPECT_EQ(wall_name(wall_index(5), naming), "wall far");
  EXPECT_EQ(wall_name(wall_index(5), wall_naming(built(crowd_scene()).world.settings().enclosure)),
            "wall -z");
  for (int wall = 0; wall < kWallCount; ++wall) {
    EXPECT_EQ(wall_named(wall_name(wall_index(wall), naming)), wall_index(wall));
  }
  EXPECT_EQ(scene_refusal(changed(free_scene(), "/bodies/0/name", "wall right")),
            "/bodies/0/name: expected a name that is no wall's, got \"wall right\"");
}

TEST(ViewFrustumScene, ACrowdWithoutRoomInViewIsRefused) {
  json scene = frustum_crowd();
  scene["enclosure"]["front_deg"] = 0;
  scene["enclosure"]["back_deg"] = 2;
  EXPECT_EQ(scene_refusal(scene),
            "/crowd/count: expected as many bodies as the enclosure has room for, got 5");
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
TEST(ViewFrustumScene, OfItsWallsOnlyTheFarOneIsSeenFromTheEye) {
  const StagedScene scene = built(frustum_crowd());
  const Enclosure& walls = *scene.world.settings().enclosure;
  EXPECT_EQ(walls_facing(walls, scene.viewer.eye), std::vector<int>{5});
  const Vector3 aside = scene.viewer.eye - 0.3 * scene.viewer.right;
  EXPECT_EQ(walls_facing(walls, aside), (std::vector<int>{0, 5}));
}
#endif

json turning_crowd() {
  json scene = changed(crowd_scene(), "/viewer/turn_deg_s", 30);
  scene["duration_s"] = 2;
  scene["engine"]["region"]["kind"] = "random";
  return scene;
}

TEST(TurningViewer, GoesRoundAtItsRateAndKeepsItsDistance) {
  const StagedScene scene = built(turning_crowd());
  const double distance_m = scene.viewer.screen.viewing_distance_m;
  for (const double time_s : {0.0, 0.5, 1.75}) {
    const Viewer viewer = scene.viewer_at_time(time_s);
    EXPECT_NEAR(viewer.eye.norm(), distance_m, 1e-12);
    EXPECT_NEAR(viewer.eye.x(), distance_m * std::sin(time_s * std::acos(-1.0) / 6.0), 1e-12);
    // v = dx/dt, by central differences
    constexpr double kStep_s = 1e-4;
    const Vector3 moved =
        scene.viewer_at_time(time_s + kStep_s).eye - scene.viewer_at_time(time_s - kStep_s).eye;
    EXPECT_NEAR((moved / (2.0 * kStep_s) - viewer.velocity).norm(), 0.0, 1e-8);
    EXPECT_NEAR(viewer.turning.norm(), std::acos(-1.0) / 6.0, 1e-12);
  }
}

TEST(TurningViewer, OneWhoStaysHasTheBitsOfOneWithoutATurn) {
  const StagedScene still = built(changed(crowd_scene(), "/viewer/turn_deg_s", 0));
  const Viewer later = still.viewer_at_time(7.3);
  EXPECT_EQ(later.eye, still.viewer.eye);
  EXPECT_EQ(later.right, still.viewer.right);
  EXPECT_EQ(later.velocity, Vector3::Zero());
}

std::vector<StepRecord> played(const json& scene) {
  LiveRun live(built(scene), /*seed=*/5);
  static_cast<void>(live.poses_at(2.0));
  return live.take_steps();
}

TEST(TurningViewer, WhatIsSeenFromTheTurningEyeDecidesAndReplaysTheSame) {
  const std::vector<StepRecord> recorded = played(turning_crowd());
  EXPECT_FALSE(replay(built(turning_crowd()), recorded, {}).divergence);
  const std::vector<StepRecord> still = played(changed(turning_crowd(), "/viewer/turn_deg_s", 0));
  ASSERT_EQ(still.size(), recorded.size());
  EXPECT_NE(still.back().state.hash, recorded.back().state.hash)
      << "the turn decided nothing: no test of the replay";
}

TEST(TurningViewer, PicturesAreOfTheirOwnTime) {
  const StagedScene scene = built(turning_crowd());
  const std::vector<Pose> poses(scene.looks.size());
  const Picture picture = picture_of(scene, poses, 1.0, {});
  EXPECT_EQ(picture.viewer.eye, scene.viewer_at_time(1.0).eye);
  EXPECT_NE(picture.viewer.eye, scene.viewer.eye);
}

}  // namespace impetus::view_test
