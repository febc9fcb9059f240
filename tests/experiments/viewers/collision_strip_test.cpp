// One collision at each level: what the levels have in common and where they differ, and the
// picture of it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "experiments/files/scene_files.hpp"
#include "experiments/run/level_collision.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_scenes.hpp"
#include "tests/places/places.hpp"

#ifdef IMPETUS_PROGRAM_HAS_WINDOW
#include "tests/experiments/read_png.hpp"
#endif

namespace impetus::collision_strip_test {

constexpr const char* kBlocks = "stimuli/two-l-blocks.json";

StagedScene two_blocks() { return built(json::parse(shipped(kBlocks))); }

TEST(CollisionByLevel, ACoarserLevelTouchesNoLaterAndWithNoSmallerBounds) {
  const CollisionByLevel collision = collision_by_level(two_blocks());
  ASSERT_EQ(collision.levels.size(), 5U);
  EXPECT_EQ(collision.bodies, (std::vector<std::size_t>{0, 1}));
  for (std::size_t level = 0; level < collision.levels.size(); ++level) {
    const LevelCollision& row = collision.levels[level];
    EXPECT_EQ(row.level, static_cast<int>(level));
    EXPECT_FALSE(row.touching.empty());
    EXPECT_FALSE(row.contacts.empty());
    EXPECT_LT(row.moments[kBeforeContact].time_s, row.moments[kAtContact].time_s);
    EXPECT_GT(row.moments[kAfterContact].time_s, row.moments[kAtContact].time_s);
    if (level > 0) {
      const LevelCollision& coarser = collision.levels[level - 1];
      EXPECT_LE(coarser.moments[kAtContact].time_s, row.moments[kAtContact].time_s);
      EXPECT_GE(coarser.fit_error_m, row.fit_error_m);
      EXPECT_GE(coarser.gap_m, row.gap_m);
    }
  }
  EXPECT_GT(collision.levels[0].gap_m, collision.levels[4].gap_m);
  EXPECT_EQ(collision.levels[4].normal_off_deg, 0.0);
}

TEST(CollisionByLevel, TheFinestLevelsCollisionIsTheScenesOwn) {
  StagedScene scene = two_blocks();
  FixedWork meter(kUnlimitedTests);
  StepReport report;
  int step = 0;
  while (report.collisions.empty()) {
    ASSERT_LT(++step, 1000);
    report = scene.world.step({1.0 / scene.step_hz, scene.viewer}, meter);
  }
  const LevelCollision finest = collision_by_level(two_blocks()).levels.back();
  EXPECT_EQ(finest.moments[kAtContact].time_s, step / scene.step_hz);
  EXPECT_EQ(finest.moments[kAtContact].poses[0].position, scene.world.states()[0].pose.position);
  EXPECT_EQ(finest.contacts[0].point, report.collisions[0].contact.touch.point);
}

TEST(CollisionByLevel, AtTheRootTheBoundingSpheresThemselvesTouch) {
  const StagedScene scene = two_blocks();
  const LevelCollision root = collision_by_level(scene).levels.front();
  ASSERT_EQ(root.touching.size(), 2U);
  double reach_m = 0.0;
  for (const RoundedBox& node : root.touching) {
    EXPECT_TRUE(node.half_extents_m.isZero(0.0));
    reach_m += node.radius_m;
  }
  const double apart_m = (root.touching[0].centre - root.touching[1].centre).norm();
  EXPECT_LE(apart_m, reach_m);
  const double step_m = 2.0 * root.moments[kBeforeContact].velocities[0].norm() / scene.step_hz;
  EXPECT_GT(apart_m, reach_m - step_m) << "they touched a step before";
}

TEST(CollisionByLevel, OfACrowdTwoBodiesThatMeetAreTakenAndNotAWall) {
  json scene = crowd_scene();
  scene["crowd"]["count"] = 15;
  scene["crowd"]["speed_deg_s"] = 20;
  const CollisionByLevel collision = collision_by_level(built(scene));
  EXPECT_EQ(collision.bodies.size(), 2U);
  EXPECT_EQ(collision.levels.size(), 5U);
}

TEST(CollisionByLevel, ABodyAloneMeetsAWall) {
  json scene = free_scene();
  scene["bodies"].erase(2);
  scene["bodies"].erase(1);
  const CollisionByLevel collision = collision_by_level(built(scene));
  EXPECT_EQ(collision.bodies, std::vector<std::size_t>{0});
  EXPECT_GT(collision.levels[0].moments[kBeforeContact].velocities[0].x(), 0.0);
  EXPECT_LT(collision.levels[0].moments[kAfterContact].velocities[0].x(), 0.0);
}

TEST(CollisionByLevel, APartOfAFigureMeetsWhatItsHingesBringItTo) {
  const JsonDocument scene = load_scene(source_folder() + "/stimuli/figure-and-bodies.json");
  const CollisionByLevel collision = collision_by_level(built(scene.value));
  EXPECT_EQ(collision.bodies.size(), 2U);
  EXPECT_GE(collision.levels.size(), 2U);
}

TEST(CollisionByLevel, ASceneInWhichNothingTouchesIsRefused) {
  json scene = free_scene();
  scene["bodies"][0].erase("velocity_deg_s");
  EXPECT_EQ(refusal([&] { static_cast<void>(collision_by_level(built(scene))); }),
            "expected a collision within the scene's 2 s, but nothing touches");
}

#ifdef IMPETUS_PROGRAM_HAS_WINDOW

class CollisionStrip : public ::testing::Test {
 protected:
  ProgramResult strip(const json& scene, std::vector<std::string> words = {}) {
    folder_.write("scene.json", scene.dump());
    words.insert(words.begin(), {"preview", "scene.json", "--strip", "a.png"});
    return run_program(folder_, words);
  }

  TemporaryFolder folder_;
};

TEST_F(CollisionStrip, HasARowForEachLevelAndNoTwoAlike) {
  const ProgramResult result =
      strip(json::parse(shipped(kBlocks)), {"--width", "200", "--height", "150"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("written to a.png, levels 0 to 4"), std::string::npos);
  const Pixels picture = read_png(folder_ / "a.png");
  EXPECT_EQ(picture.width, 3 * 200);
  ASSERT_EQ(picture.height, 5 * 150);
  std::set<std::string> rows;
  const std::ptrdiff_t bytes = 3 * 600 * 150;
  for (std::ptrdiff_t level = 0; level < 5; ++level) {
    rows.emplace(picture.rgb.begin() + level * bytes, picture.rgb.begin() + (level + 1) * bytes);
  }
  EXPECT_EQ(rows.size(), 5U);
}

TEST_F(CollisionStrip, WhatCannotBePicturedIsRefused) {
  json still = free_scene();
  still["bodies"][0].erase("velocity_deg_s");
  EXPECT_EQ(strip(still).errors,
            kAssumedScreen +
                "impetus: scene.json: expected a collision within the scene's 2 s, but nothing "
                "touches\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.png"));
  EXPECT_EQ(strip(free_scene(), {"--width", "9000"}).errors,
            "impetus: --width: expected from 1 to 8192 pixels, got 9000\n");
  folder_.write("a.png", "mine");
  const ProgramResult result = strip(free_scene());
  EXPECT_EQ(result.errors, "impetus: a.png: exists already and is not overwritten\n");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(text_of(folder_ / "a.png"), "mine");
}

#endif

}  // namespace impetus::collision_strip_test
