// A scene that begins still, flashes who is meant and is hidden before its end: the world is the
// one that it would be without, and what nobody sees is simulated all the same.
// SPDX-License-Identifier: MIT
#include "experiments/record/ports.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/run/touching.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::showing_test {

/// Still for half a second, with ball and box flashing, then shown for a quarter.
json shown_scene() {
  json scene = free_scene();
  scene["still_s"] = 0.5;
  scene["flashing"] = json::parse(R"({"bodies": ["ball", "box"], "hz": 2, "colour": "#ff0000"})");
  scene["hidden_after_s"] = 0.25;
  return scene;
}

TEST(Showing, EveryRefusalNamesThePlace) {
  const std::vector<Case> cases{
      {"/still_s", 0.501, "/still_s: expected a whole number of steps of 1/240 s, got 0.501"},
      {"/still_s", -1, "/still_s: expected a number ≥ 0 and ≤ 60, got -1"},
      {"/still_s", 0, "/flashing: expected none without still_s, while which bodies flash"},
      {"/flashing/bodies/1", "cup", "/flashing/bodies/1: expected the name of a body, got \"cup\""},
      {"/flashing/bodies", json::array(),
       "/flashing/bodies: expected a list of 1 to 100 values without repeats, got []"},
      {"/flashing/hz", 4, "/flashing/hz: expected a number > 0 and ≤ 3, got 4"},
      {"/hidden_after_s", 2,
       "/hidden_after_s: expected less than the 2.0 s that the scene lasts, got 2"}};
  EXPECT_EQ(scene_refusal(shown_scene()), "accepted");
  for (const Case& one : cases) {
    EXPECT_EQ(scene_refusal(changed(shown_scene(), one.pointer, one.value)), one.sentence);
  }
}

TEST(Showing, AStillWorldGoesOnAfterwardsAsIfItHadNeverBeenStill) {
  SceneRun still(built(shown_scene()));
  SceneRun moving(built(free_scene()));
  const StateHash start = hash_state(moving.world().states());
  for (int step = 1; step <= 120; ++step) {
    EXPECT_EQ(still.step().state.hash, start.hash) << step;
  }
  for (int step = 1; step <= 480; ++step) {
    EXPECT_EQ(still.step().state.hash, moving.step().state.hash) << step;
  }
}

TEST(Showing, EndsWhereItIsHiddenThoughTheSceneGoesOn) {
  const StagedScene scene = built(shown_scene());
  EXPECT_EQ(scene.still_s, 0.5);
  EXPECT_EQ(scene.duration_s, 0.75);
  EXPECT_EQ(scene.whole_s(), 2.5);
  EXPECT_EQ(LiveRun(scene, 1).ends_s(), 0.75);
  EXPECT_EQ(built(free_scene()).unseen_s, 0.0);
}

TEST(Showing, WhatWasShownReplaysBitForBit) {
  LiveRun live(built(shown_scene()), 1);
  live.poses_at(live.ends_s());
  const std::vector<StepRecord> steps = live.take_steps();
  ASSERT_EQ(steps.size(), 181U);
  const ReplayResult result = replay(built(shown_scene()), steps);
  EXPECT_EQ(result.steps, 180);
  EXPECT_FALSE(result.divergence);
}

TEST(Showing, WhoIsMeantFlashesWhileNothingMoves) {
  const StagedScene scene = built(shown_scene());
  std::vector<Pose> poses;
  for (const BodyState& state : scene.start) {
    poses.push_back(state.pose);
  }
  const Colour red{1.0F, 0.0F, 0.0F};
  const auto colour_at = [&](double time_s, std::size_t body) {
    return picture_of(scene, poses, time_s, {}).bodies[body].look.colour;
  };
  // Two flashes a second: a quarter of a second each way; still for half a second.
  for (const double own_s : {0.0, 0.2, 0.5, 0.6, 1.4}) {
    EXPECT_EQ(colour_at(own_s, 0), scene.looks[0].colour) << own_s;
  }
  for (const double lit_s : {0.25, 0.4}) {
    EXPECT_EQ(colour_at(lit_s, 0), red) << lit_s;
    EXPECT_EQ(colour_at(lit_s, 1), red) << lit_s;
    EXPECT_EQ(colour_at(lit_s, 2), scene.looks[2].colour) << lit_s;
  }
}

TEST(Showing, WhatTouchesUnseenTouches) {
  const StagedScene scene = built(shown_scene());
  EXPECT_TRUE(touch_by_the_end(scene, {"ball", "box"}));  // after .8 s or so, out of .25
  EXPECT_TRUE(touch_by_the_end(scene, {"box", "ball"}));
  EXPECT_FALSE(touch_by_the_end(scene, {"ball", "cup"}));
  EXPECT_FALSE(
      touch_by_the_end(built(changed(shown_scene(), "/duration_s", 0.5)), {"ball", "box"}));
  EXPECT_FALSE(touch_by_the_end(
      built(changed(shown_scene(), "/bodies/0/velocity_deg_s", {0, 0, 0})), {"ball", "box"}));
}

TEST(Showing, ATruthIsTheSameAfterTheSceneWasRun) {
  SceneRun run(built(shown_scene()));
  for (int step = 0; step < 500; ++step) {
    run.step_whole();
  }
  EXPECT_TRUE(touch_by_the_end(run.scene(), {"ball", "box"}));
}

}  // namespace impetus::showing_test
