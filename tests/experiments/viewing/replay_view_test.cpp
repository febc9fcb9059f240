// What the viewer of replays shows of a trial, without its window.
// SPDX-License-Identifier: MIT
#include "experiments/files/scene_files.hpp"
#include "experiments/viewing/replay_simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/places/places.hpp"

namespace impetus::replay_view_test {

using Kind = TimelineMark::Kind;

constexpr std::uint64_t kSeed = 7;
constexpr double kRadius_deg = 5.0;

StagedScene cube(RegionKind kind) {
  const JsonDocument scene =
      load_scene(std::filesystem::path(source_folder()) / "stimuli/l-blocks-in-a-cube.json");
  ShapeLibrary shapes;
  StagedScene staged = build_scene(scene.value, assumed_screen(), 0.0, shapes);
  staged.region = {kind, kRadius_deg, 60};
  return staged;
}

/// Where the participant looks in a frame: from left to right, a centimetre a second.
ScreenPoint looked_at(int frame) { return {0.01 * (frame / 60.0 - 1.0), 0.02}; }

struct Recorded {
  std::vector<StepRecord> steps;
  std::vector<CollisionRecord> collisions;
};

/// Two seconds of a trial, as a session records them.
Recorded two_seconds(RegionKind kind) {
  LiveRun live(cube(kind), kSeed);
  for (int frame = 0; frame <= 120; ++frame) {
    live.look_at({looked_at(frame), frame * 16'000'000, 0, {}});
    static_cast<void>(live.poses_at(frame / 60.0));
  }
  return {live.take_steps(), live.take_collisions()};
}

std::int64_t count(const ReplayView& view, Kind kind) {
  return std::count_if(view.marks.begin(), view.marks.end(),
                       [kind](const TimelineMark& mark) { return mark.kind == kind; });
}

TEST(ReplayView, LooksAsTheScenesAppearanceSays) {
  const JsonDocument scene =
      load_scene(std::filesystem::path(source_folder()) / "stimuli/two-balls-on-the-ground.json");
  ShapeLibrary shapes;
  const StagedScene staged = build_scene(scene.value, assumed_screen(), 0.0, shapes);
  ASSERT_NE(staged.appearance, nullptr);
  LiveRun live(staged, kSeed);
  static_cast<void>(live.poses_at(0.1));
  EXPECT_EQ(view_of(staged, live.take_steps()).appearance, staged.appearance);
}

TEST(ReplayView, HasTheGazeAndTheRegionOfEveryStep) {
  const std::vector<StepRecord> steps = two_seconds(RegionKind::kTracked).steps;
  const ReplayView view = view_of(cube(RegionKind::kTracked), steps);
  EXPECT_TRUE(view.agrees);
  ASSERT_EQ(view.states.size(), 481U);
  ASSERT_EQ(view.gaze.size(), view.states.size());
  EXPECT_FALSE(gaze_of_step(view, 0).fixation);
  for (int step = 1; step <= 480; ++step) {
    const GazeInput gaze = gaze_of_step(view, step);
    ASSERT_TRUE(gaze.fixation && gaze.region) << step;
    constexpr double kOneFrame_m = 0.01 / 60.0;  // a step belongs to the frame before or after it
    EXPECT_NEAR(gaze.fixation->x_m, looked_at(step / 4).x_m, 1.01 * kOneFrame_m);
    EXPECT_EQ(gaze.region->centre, *gaze.fixation);
    EXPECT_EQ(gaze.region->radius_deg, kRadius_deg);
  }
  EXPECT_FALSE(gaze_of_step(view, 481).fixation);
  EXPECT_FALSE(gaze_of_step(view, -1).fixation);
}

TEST(ReplayView, KnowsNoGazeWhereNoneWasRecorded) {
  LiveRun live(cube(RegionKind::kAllBad), kSeed);
  static_cast<void>(live.poses_at(0.5));
  const ReplayView view = view_of(cube(RegionKind::kAllBad), live.take_steps());
  EXPECT_FALSE(gaze_of_step(view, 60).fixation);
  EXPECT_FALSE(gaze_of_step(view, 60).region);
}

TEST(ReplayView, MarksEveryCollisionByWhetherItWasFine) {
  const Recorded good = two_seconds(RegionKind::kAllGood);
  const ReplayView fine = view_of(cube(RegionKind::kAllGood), good.steps);
  ASSERT_GT(good.collisions.size(), 0U);
  EXPECT_EQ(count(fine, Kind::kFineCollision), static_cast<std::int64_t>(good.collisions.size()));
  EXPECT_EQ(count(fine, Kind::kCoarseCollision), 0);
  EXPECT_DOUBLE_EQ(fine.marks.front().begin_s, good.collisions.front().time_s);

  const Recorded bad = two_seconds(RegionKind::kAllBad);
  const ReplayView coarse = view_of(cube(RegionKind::kAllBad), bad.steps);
  ASSERT_GT(bad.collisions.size(), 0U);
  EXPECT_EQ(count(coarse, Kind::kCoarseCollision),
            static_cast<std::int64_t>(bad.collisions.size()));
  EXPECT_EQ(count(coarse, Kind::kFineCollision), 0);
}

TEST(ReplayView, OfAnInterruptedTrialEndsWithItsLastStep) {
  std::vector<StepRecord> steps = two_seconds(RegionKind::kAllGood).steps;
  steps.resize(241);
  ReplayView view = view_of(cube(RegionKind::kAllGood), steps);
  EXPECT_EQ(view.duration_s, 10.0);
  view.marks.push_back({Kind::kClick, 0.9, 0.9, ""});
  view.marks.push_back({Kind::kClick, 1.1, 1.1, ""});
  end_with_last_step(view);
  EXPECT_EQ(view.duration_s, 1.0);
  EXPECT_EQ(count(view, Kind::kClick), 1);
}

TEST(ReplayView, SaysWhenAStepDiffersFromItsRecord) {
  std::vector<StepRecord> steps = two_seconds(RegionKind::kTracked).steps;
  EXPECT_TRUE(view_of(cube(RegionKind::kTracked), steps).agrees);
  steps[100].state.hash ^= 1U;
  EXPECT_FALSE(view_of(cube(RegionKind::kTracked), steps).agrees);
}

}  // namespace impetus::replay_view_test
