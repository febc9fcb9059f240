// What a participant of the gap study is shown: blocks that meet at a level of their trees.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/live_run.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::gap_stimulus_test {

constexpr double kHz = 60.0;
constexpr std::int64_t kContactStep = 240;

const Protocol& gap() {
  static const Protocol protocol = load_protocol(source_file("protocols/gap.json"));
  return protocol;
}

/// A condition played to its end.
struct Played {
  std::vector<CollisionRecord> collisions;
  std::vector<Pose> start;
  std::vector<Pose> end;
  CollisionTruth truth;
};

Played play(const Condition& cell) {
  static const ProtocolScenes scenes(gap(), 0.0);
  const StagedScene staged = scenes.stage(cell, assumed_screen());
  LiveRun live(staged, 1);
  Played played;
  const auto frames = static_cast<std::int64_t>(staged.duration_s * kHz);
  for (std::int64_t frame = 0; frame <= frames; ++frame) {
    const std::vector<Pose> poses = live.poses_at(static_cast<double>(frame) / kHz);
    played.start = frame == 0 ? poses : played.start;
    played.end = poses;
  }
  played.collisions = live.take_collisions();
  if (!played.collisions.empty()) {
    const CollisionRecord& first = played.collisions.front();
    played.truth =
        measure_truth(staged.looks[0], first.pose_a, staged.looks[1], first.pose_b, staged.viewer);
  }
  return played;
}

Condition condition(double level, double viewpoint_deg, double speed_percent) {
  return {{"level", level}, {"viewpoint_deg", viewpoint_deg}, {"speed_percent", speed_percent}};
}

TEST(GapStimulus, ContactFallsOnItsStepAtTheLevelAskedInEveryCell) {
  for (const Condition& cell : cells(gap().design)) {
    const Played played = play(cell);
    ASSERT_EQ(played.collisions.size(), 1U) << to_json(cell).dump();
    const CollisionRecord& collision = played.collisions.front();
    EXPECT_EQ(collision.step, kContactStep);
    EXPECT_EQ(collision.report.level, static_cast<int>(std::get<double>(cell[0].value)));
    EXPECT_TRUE(collision.no_spin);
    EXPECT_EQ(collision.report.contact.touch.point.x(), 0.0);
  }
}

TEST(GapStimulus, BlocksAreRepelledStraightBackWithoutTurning) {
  for (const double level : {0.0, 2.0, 4.0}) {
    const Played played = play(condition(level, 0, 100));
    for (std::size_t body = 0; body < 2; ++body) {
      // A second in and a second out at the same speed: back to the start, but for the rounding of
      // 480 steps of 0.4 mm and of the averaged normal.
      EXPECT_LT((played.end[body].position - played.start[body].position).norm(), 1e-12);
      EXPECT_EQ(played.end[body].orientation.coeffs(), played.start[body].orientation.coeffs());
    }
  }
}

TEST(GapStimulus, TheGapShrinksWithEveryLevelAndIsThereAtTheRoot) {
  const double root = play(condition(0, 0, 100)).truth.gap_arcmin;
  const double middle = play(condition(2, 0, 100)).truth.gap_arcmin;
  const double finest = play(condition(4, 0, 100)).truth.gap_arcmin;
  EXPECT_GT(root, 2.0 * middle);
  EXPECT_GT(middle, 2.0 * finest);
  EXPECT_GT(finest, 0.0);
}

TEST(GapStimulus, TheViewpointForeshortensTheGapAndSpeedDoesNotChangeIt) {
  const CollisionTruth front = play(condition(0, 0, 100)).truth;
  const CollisionTruth side = play(condition(0, 85, 100)).truth;
  EXPECT_LT(side.gap_arcmin, 0.2 * front.gap_arcmin);
  EXPECT_EQ(side.gap_m, front.gap_m);
  EXPECT_NEAR(play(condition(0, 0, 150)).truth.gap_m, front.gap_m, 1e-9 * front.gap_m);
}

/// Two cubes of 1 cm side by side with a gap of 1 mm, seen from 57 cm.
struct TwoCubes {
  explicit TwoCubes(double azimuth_deg)
      : viewer(viewer_at(assumed_screen(), azimuth_deg)),
        look{"cube", 0.0087, {}, std::make_shared<const TriangleMesh>(box_mesh({.01, .01, .01}))} {}

  [[nodiscard]] CollisionTruth truth(double gap_m) const {
    const Pose left{Vector3(-0.005 - 0.5 * gap_m, 0, 0), Quaternion::Identity()};
    const Pose right{Vector3(0.005 + 0.5 * gap_m, 0, 0), Quaternion::Identity()};
    return measure_truth(look, left, look, right, viewer);
  }

  Viewer viewer;
  DrawnBody look;
};

TEST(CollisionTruth, OfTwoCubesIsTheirGap) {
  const CollisionTruth truth = TwoCubes(0.0).truth(0.001);
  EXPECT_NEAR(truth.gap_m, 0.001, 1e-12);
  // 1 mm within 5 mm of the plane at 57 cm: 6.03 minutes of arc, 3.4 pixels; 1 % for the depth.
  EXPECT_NEAR(truth.gap_arcmin, 0.001 / 0.57 * 3437.75, 0.06);
  EXPECT_NEAR(truth.gap_px, 0.001 * 1280 / 0.376, 0.04);
}

TEST(CollisionTruth, OfTouchingCubesIsNothing) {
  const CollisionTruth truth = TwoCubes(0.0).truth(0.0);
  EXPECT_NEAR(truth.gap_m, 0.0, 1e-15);
  EXPECT_EQ(truth.hidden_share, 0.0);
}

TEST(CollisionTruth, SeenAlongTheLineOfApproachTheNearBodyHidesAll) {
  EXPECT_EQ(TwoCubes(90.0).truth(0.001).hidden_share, 1.0);
}

TEST(CollisionTruth, OfTwoSpheresIsOnTheLineOfTheirCentres) {
  const DrawnBody ball{"ball", 0.01, {}, nullptr};
  const Viewer viewer = viewer_at(assumed_screen(), 0.0);
  const CollisionTruth truth =
      measure_truth(ball, {Vector3(-0.011, 0, 0), Quaternion::Identity()}, ball,
                    {Vector3(0.011, 0, 0), Quaternion::Identity()}, viewer);
  EXPECT_NEAR(truth.gap_m, 0.002, 1e-15);
  EXPECT_EQ(truth.hidden_share, 0.0);
  EXPECT_NEAR(truth.gap_arcmin, 2.0 * std::atan(0.001 / 0.57) * 3437.7468, 1e-3);
}

}  // namespace impetus::gap_stimulus_test
