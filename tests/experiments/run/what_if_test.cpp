// Recorded trials simulated again under other settings of the engine.
// SPDX-License-Identifier: MIT
#include "experiments/run/what_if.hpp"

#include <gtest/gtest.h>

#include "experiments/run/live_run.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::what_if_test {

constexpr std::uint64_t kSeed = 7;
constexpr double kRecorded_s = 1.5;

/// L-blocks in a cube: by a region of this kind, or nearest first within a budget.
json cube_by_region(const std::string& kind) {
  json scene = changed(crowd_scene(), "/crowd/count", 10);
  return changed(std::move(scene), "/engine/region/kind", kind);
}

json cube_within(std::int64_t tests_per_step) {
  json scene = changed(crowd_scene(), "/crowd/count", 10);
  scene["engine"].erase("region");
  scene["engine"]["schedule"] =
      json::object({{"scheduler", "distance"}, {"lists", json::array({json::object()})}});
  scene["engine"]["budget"] = json::object({{"tests_per_step", tests_per_step}});
  return scene;
}

/// As a session records it: the participant's gaze goes round the screen's middle.
std::vector<StepRecord> recorded(const StagedScene& scene) {
  LiveRun live(scene, kSeed);
  for (int frame = 0; frame <= kRecorded_s * 60; ++frame) {
    const ScreenPoint place{0.03 * ((frame / 20) % 3 - 1), 0.02 * ((frame / 30) % 2)};
    live.look_at({place, frame, 0, {}});
    static_cast<void>(live.poses_at(frame / 60.0));
  }
  return live.take_steps();
}

double mean_level(const WhatIfCourse& course) {
  double sum = 0.0;
  for (const SeenCollision& collision : course.collisions) {
    sum += collision.level;
  }
  return sum / static_cast<double>(course.collisions.size());
}

TEST(WhatIf, UnderTheRecordedSettingsNothingDiffers) {
  for (const json& scene : {cube_by_region("tracked"), cube_by_region("random"),
                            cube_by_region("all-bad"), cube_within(300)}) {
    const StagedScene staged = built(scene);
    const std::vector<StepRecord> steps = recorded(staged);
    const WhatIf outcome = what_if(staged, staged, steps, kSeed);
    EXPECT_FALSE(outcome.divergence);
    EXPECT_FALSE(outcome.parts_at);
    EXPECT_FALSE(outcome.seen_apart_at);
    EXPECT_EQ(outcome.steps, static_cast<std::int64_t>(steps.size()) - 1);
    ASSERT_GT(outcome.then.collisions.size(), 0U);
    ASSERT_EQ(outcome.then.collisions.size(), outcome.now.collisions.size());
    EXPECT_EQ(outcome.then.work_spent, outcome.now.work_spent);
    EXPECT_EQ(outcome.matches.size(), outcome.then.collisions.size());
    for (const CollisionMatch& match : outcome.matches) {
      ASSERT_TRUE(match.then && match.now);
      const SeenCollision& then = outcome.then.collisions[*match.then];
      const SeenCollision& now = outcome.now.collisions[*match.now];
      EXPECT_EQ(then.step, now.step);
      EXPECT_EQ(then.level, now.level);
      EXPECT_EQ(then.visible_arcmin, now.visible_arcmin);
      EXPECT_EQ(then.at_gaze_arcmin, now.at_gaze_arcmin);
    }
  }
}

TEST(WhatIf, ARandomRegionAskedForAnewIsTheOneThatTheSeedDraws) {
  // Recorded at random places; the other settings differ in a part of the region that random places
  // do not depend on, so that its own rule must find every recorded place again.
  const StagedScene then = built(cube_by_region("random"));
  StagedScene now = then;
  now.region.point = {0.01, 0.0};
  const WhatIf outcome = what_if(then, now, recorded(then), kSeed);
  EXPECT_FALSE(outcome.parts_at);
  EXPECT_EQ(outcome.matches.size(), outcome.then.collisions.size());
}

TEST(WhatIf, ASmallerBudgetLowersLevelsAndLeavesWiderGaps) {
  const StagedScene then = built(cube_within(1'000'000));
  const WhatIf outcome = what_if(then, built(cube_within(0)), recorded(then), kSeed);
  ASSERT_GT(outcome.then.collisions.size(), 0U);
  ASSERT_GT(outcome.now.collisions.size(), 0U);
  EXPECT_EQ(mean_level(outcome.then), 4.0);
  EXPECT_EQ(mean_level(outcome.now), 0.0);
  EXPECT_LT(outcome.now.work_spent, outcome.then.work_spent);
  double then_arcmin = 0.0;
  double now_arcmin = 0.0;
  for (const SeenCollision& collision : outcome.then.collisions) {
    then_arcmin += collision.visible_arcmin / static_cast<double>(outcome.then.collisions.size());
  }
  for (const SeenCollision& collision : outcome.now.collisions) {
    now_arcmin += collision.visible_arcmin / static_cast<double>(outcome.now.collisions.size());
    EXPECT_LE(collision.at_gaze_arcmin, collision.visible_arcmin);
    EXPECT_LE(collision.visible_arcmin, collision.gap_arcmin);
  }
  EXPECT_GT(now_arcmin, then_arcmin);
  ASSERT_TRUE(outcome.parts_at && outcome.seen_apart_at);
  EXPECT_LE(*outcome.parts_at, *outcome.seen_apart_at);
}

TEST(WhatIf, ARegionWhereTheParticipantLookedIsFineThereAlone) {
  const StagedScene then = built(cube_by_region("all-bad"));
  StagedScene now = built(cube_by_region("tracked"));
  const WhatIf outcome = what_if(then, now, recorded(then), kSeed);
  bool fine = false;
  bool coarse = false;
  for (const SeenCollision& collision : outcome.now.collisions) {
    fine |= collision.level == 4;
    coarse |= collision.level == 0;
  }
  EXPECT_TRUE(fine);
  EXPECT_TRUE(coarse);
}

TEST(WhatIf, OfARecordingThatDivergesSaysWhereAndNoMore) {
  const StagedScene scene = built(cube_by_region("all-bad"));
  std::vector<StepRecord> steps = recorded(scene);
  steps[50].state.hash ^= 1U;
  const WhatIf outcome = what_if(scene, scene, steps, kSeed);
  ASSERT_TRUE(outcome.divergence);
  EXPECT_EQ(outcome.divergence->step, 50);
  EXPECT_TRUE(outcome.matches.empty());
}

SeenCollision at(std::int64_t step, BodyPair bodies) {
  SeenCollision collision;
  collision.step = step;
  collision.bodies = bodies;
  return collision;
}

TEST(Matched, PairsOffTheSameBodiesWithinTheWindowEachOnce) {
  const std::vector<SeenCollision> then{at(10, {0, 1}), at(14, {0, 1}), at(40, {0, 2}),
                                        at(90, {0, 1})};
  const std::vector<SeenCollision> now{at(8, {1, 2}), at(12, {0, 1}), at(45, {0, 2}),
                                       at(96, {0, 1})};
  const std::vector<CollisionMatch> matches = matched(then, now, /*within_steps=*/5);
  std::string words;
  for (const CollisionMatch& match : matches) {
    words += (match.then ? std::to_string(*match.then) : "-") + ":" +
             (match.now ? std::to_string(*match.now) : "-") + " ";
  }
  EXPECT_EQ(words, "-:0 0:1 1:- 2:2 3:- -:3 ");
}

}  // namespace impetus::what_if_test
