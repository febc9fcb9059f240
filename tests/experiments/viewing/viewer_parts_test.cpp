// What the viewer of replays computes: time, jumps, gaze, camera, file names, the finest level.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>

#include "experiments/run/live_run.hpp"
#include "experiments/viewing/orbit_camera.hpp"
#include "experiments/viewing/replay_playback.hpp"
#include "experiments/viewing/replay_simulation.hpp"
#include "experiments/viewing/viewed_stimuli.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::viewer_parts_test {

using Kind = TimelineMark::Kind;

constexpr std::uint64_t kSeed = 7;

StagedScene cube(const std::string& region) {
  return built(changed(changed(crowd_scene(), "/crowd/count", 10), "/engine/region/kind", region));
}

std::vector<StepRecord> recorded(const StagedScene& scene, double until_s) {
  LiveRun live(scene, kSeed);
  static_cast<void>(live.poses_at(until_s));
  return live.take_steps();
}

/// Two seconds of nothing at 100 steps a second.
ReplayView plain_replay() {
  ReplayView replay;
  replay.step_hz = 100.0;
  replay.duration_s = 2.0;
  replay.states.resize(201);
  return replay;
}

// ---------------------------------------------------------------- time

TEST(ReplayPlayback, StepsStandOnSteps) {
  const ReplayView replay = plain_replay();
  ReplayPlayback live(replay);
  live.advance(0.5034);
  EXPECT_TRUE(live.playing());
  live.step(1);
  EXPECT_FALSE(live.playing());
  EXPECT_EQ(live.step_number(), 51);
  for (int i = 0; i < 100; ++i) {
    live.step(1);
  }
  EXPECT_EQ(live.step_number(), 151);
  for (int i = 0; i < 100; ++i) {
    live.step(-1);
  }
  EXPECT_EQ(live.step_number(), 51);
}

TEST(ReplayPlayback, SpeedsGoByHalvesFromASixteenthToFour) {
  const ReplayView replay = plain_replay();
  ReplayPlayback live(replay);
  std::string speeds;
  for (int i = 0; i < 4; ++i) {
    live.change_speed(1);
    speeds += live.speed_words() + " ";
  }
  for (int i = 0; i < 8; ++i) {
    live.change_speed(-1);
    speeds += live.speed_words() + " ";
  }
  EXPECT_EQ(speeds, "×2 ×4 ×4 ×4 ×2 ×1 ×1/2 ×1/4 ×1/8 ×1/16 ×1/16 ×1/16 ");
  live.advance(1.6);
  EXPECT_DOUBLE_EQ(live.time_s(), 0.1);
}

TEST(ReplayPlayback, PlaysFromTheStartAgainAtTheEnd) {
  ReplayView replay = plain_replay();
  replay.marks.push_back({Kind::kResponse, 2.5, 2.5, ""});
  ReplayPlayback live(replay);
  EXPECT_DOUBLE_EQ(live.span_s(), 2.5);
  live.advance(9.0);
  EXPECT_FALSE(live.playing());
  EXPECT_DOUBLE_EQ(live.time_s(), 2.5);
  EXPECT_EQ(live.step_number(), 200);
  live.toggle();
  EXPECT_DOUBLE_EQ(live.time_s(), 0.0);
}

// ---------------------------------------------------------------- jumps

TEST(TimelineJumps, GoToTheNextMarkOfTheirKindAndStopAtTheLast) {
  const std::vector<TimelineMark> marks{{Kind::kCoarseCollision, 0.5, 0.5, ""},
                                        {Kind::kClick, 0.7, 0.7, ""},
                                        {Kind::kFineCollision, 1.0, 1.0, ""},
                                        {Kind::kFineCollision, 1.0, 1.0, ""},
                                        {Kind::kLateFrame, 1.2, 1.2, ""}};
  const auto jump = [&](JumpTarget target, double from_s, int direction) {
    return jump_from(marks, target, from_s, direction, /*step_hz=*/240.0);
  };
  EXPECT_EQ(jump(JumpTarget::kCollision, 0.0, 1), 0.5);
  EXPECT_EQ(jump(JumpTarget::kCollision, 0.5, 1), 1.0);
  EXPECT_EQ(jump(JumpTarget::kCollision, 1.0, 1), std::nullopt);
  EXPECT_EQ(jump(JumpTarget::kCollision, 1.0, -1), 0.5);
  EXPECT_EQ(jump(JumpTarget::kCollision, 2.0, -1), 1.0);
  EXPECT_EQ(jump(JumpTarget::kClick, 0.0, 1), 0.7);
  EXPECT_EQ(jump(JumpTarget::kLateFrame, 2.0, -1), 1.2);
  EXPECT_EQ(jump(JumpTarget::kResponse, 0.0, 1), std::nullopt);
  EXPECT_TRUE(has_target(marks, JumpTarget::kCollision));
  EXPECT_FALSE(has_target(marks, JumpTarget::kResponse));
}

// ---------------------------------------------------------------- gaze

constexpr std::int64_t kOnset_ns = 5'000'000'000;

GazeSample sample(std::int64_t after_onset_ms, Fixation at, GazeLoss loss = GazeLoss::kNone,
                  std::int64_t interval = 1) {
  return {kOnset_ns + after_onset_ms * 1'000'000, at, loss, interval};
}

TEST(GazeTrail, IsCorrectedAndTimedFromTheOnsetOfItsInterval) {
  GazeCorrection correction;
  correction.x0_m = 0.01;
  correction.yy = 2.0;
  const std::vector<TimedGaze> gaze =
      timed_gaze({sample(100, ScreenPoint{0.02, 0.03}),
                  sample(200, ScreenPoint{0.0, 0.0}, GazeLoss::kNone, /*interval=*/2)},
                 correction, 1, kOnset_ns);
  ASSERT_EQ(gaze.size(), 1U);
  EXPECT_DOUBLE_EQ(gaze[0].time_s, 0.1);
  EXPECT_DOUBLE_EQ(gaze[0].at->x_m, 0.03);
  EXPECT_DOUBLE_EQ(gaze[0].at->y_m, 0.06);
}

TEST(GazeTrail, ReachesBackThreeTenthsOfASecondAndIsCutWhereGazeWasLost) {
  std::vector<GazeSample> samples;
  for (int ms = 0; ms <= 1000; ms += 100) {
    const bool lost = ms == 800;
    samples.push_back(sample(ms, lost ? Fixation() : ScreenPoint{1e-3 * ms, 0.0},
                             lost ? GazeLoss::kBlink : GazeLoss::kNone));
  }
  const std::vector<TimedGaze> gaze = timed_gaze(samples, {}, 1, kOnset_ns);
  const GazeTrail trail = trail_at(gaze, 0.95);
  ASSERT_EQ(trail.points.size(), 2U);  // 0.7 and 0.9: 0.65 to 0.95 without the blink
  EXPECT_DOUBLE_EQ(trail.points[0].at.x_m, 0.7);
  EXPECT_NEAR(trail.points[0].age_s, 0.25, 1e-12);
  EXPECT_FALSE(trail.points[1].joined);
  EXPECT_EQ(trail.lost, GazeLoss::kNone);
  EXPECT_EQ(trail_at(gaze, 0.85).lost, GazeLoss::kBlink);
  EXPECT_TRUE(trail_at(gaze, 0.35).points.back().joined);
  EXPECT_TRUE(trail_at(gaze, -1.0).points.empty());
}

TEST(GazeTrail, TellsEachStretchInWhichGazeWasLost) {
  const std::vector<TimedGaze> gaze = timed_gaze(
      {sample(0, ScreenPoint{}), sample(10, {}, GazeLoss::kBlink), sample(20, {}, GazeLoss::kLost),
       sample(30, ScreenPoint{}), sample(40, {}, GazeLoss::kOffScreen)},
      {}, 1, kOnset_ns);
  const std::vector<LostStretch> lost = lost_stretches(gaze);
  ASSERT_EQ(lost.size(), 2U);
  EXPECT_DOUBLE_EQ(lost[0].begin_s, 0.01);
  EXPECT_DOUBLE_EQ(lost[0].end_s, 0.03);
  EXPECT_EQ(lost[0].loss, GazeLoss::kBlink);
  EXPECT_DOUBLE_EQ(lost[1].end_s, 0.04);
}

// ---------------------------------------------------------------- camera, names

TEST(OrbitCamera, GoesRoundTheOriginAndLooksAtIt) {
  constexpr double kRounding = 1e-12;
  const Viewer own = viewer_at(assumed_screen(), 20.0);
  OrbitCamera camera;
  camera.turn(70.0, 35.0);
  const Viewer seen = camera.seen_from(own);
  EXPECT_NEAR(seen.eye.norm(), own.eye.norm(), kRounding);
  EXPECT_NEAR(seen.right.dot(seen.up), 0.0, kRounding);
  EXPECT_NEAR((seen.right.cross(seen.up) - seen.eye.normalized()).norm(), 0.0, kRounding);
  EXPECT_NEAR(seen.eye.normalized().y(), sine_cosine_deg(35.0).sine, kRounding);
  EXPECT_NEAR(seen.right.y(), 0.0, kRounding);  // the horizon stays level
  OrbitCamera right;
  right.turn(90.0, 0.0);
  const Viewer from_right = right.seen_from(viewer_at(assumed_screen(), 0.0));
  EXPECT_GT(from_right.eye.x(), 0.99 * own.eye.norm());
}

TEST(OrbitCamera, ZoomsWithinLimitsAndReturnsInEveryBit) {
  const Viewer own = viewer_at(assumed_screen(), 0.0);
  OrbitCamera camera;
  camera.zoom(3);
  EXPECT_LT(camera.seen_from(own).screen.width_m, own.screen.width_m);
  EXPECT_FALSE(camera.is_participants());
  camera.zoom(-3);
  EXPECT_TRUE(camera.is_participants());
  camera.zoom(1000);
  EXPECT_DOUBLE_EQ(camera.magnification(), 8.0);
  camera.turn(10.0, 500.0);
  EXPECT_DOUBLE_EQ(camera.up_deg(), 89.0);
  camera.reset();
  EXPECT_EQ(camera.seen_from(own).eye, own.eye);
  EXPECT_EQ(camera.seen_from(own).screen.width_m, own.screen.width_m);
}

TEST(PictureName, SaysStudyTrialAndStepAndIsNeverTaken) {
  std::set<std::string> files;
  const auto taken = [&](const std::string& name) { return files.contains(name); };
  EXPECT_EQ(picture_name({"study", 37, 1, 1, 412}, taken), "study-trial37-step412.png");
  EXPECT_EQ(picture_name({"study", 37, 2, 2, 0}, taken),
            "study-trial37-attempt2-interval2-step0.png");
  files = {"study-trial37-step412.png", "study-trial37-step412-2.png"};
  EXPECT_EQ(picture_name({"study", 37, 1, 1, 412}, taken), "study-trial37-step412-3.png");
}

// ---------------------------------------------------------------- the finest level, beside it

struct StandingClock final : Clock {
  [[nodiscard]] std::int64_t now_ns() const override { return 0; }
};

TEST(FinestLevel, IsWhatWasRecordedWhereThatWasFine) {
  const StagedScene good = cube("all-good");
  const std::vector<StepRecord> steps = recorded(good, 1.5);
  const StandingClock clock;
  FinestBeside finest(good, steps, clock);
  EXPECT_EQ(finest.view(), nullptr);
  EXPECT_TRUE(finest.go_on());
  EXPECT_FALSE(finest.go_on());
  const ReplayView recorded_view = view_of(good, steps);
  ASSERT_EQ(finest.view()->states.size(), recorded_view.states.size());
  EXPECT_EQ(parting_step(recorded_view, *finest.view()), std::nullopt);
}

TEST(FinestLevel, PartsFromACoarseRecordingAfterItsFirstCollision) {
  const StagedScene bad = cube("all-bad");
  const std::vector<StepRecord> steps = recorded(bad, 1.5);
  const ReplayView coarse = view_of(bad, steps);
  const StandingClock clock;
  FinestBeside finest(bad, steps, clock);
  ASSERT_TRUE(finest.go_on());
  for (const TimelineMark& mark : finest.view()->marks) {
    EXPECT_NE(mark.kind, Kind::kCoarseCollision);
  }
  const auto parts = parting_step(coarse, *finest.view());
  ASSERT_TRUE(parts);
  const auto first = jump_from(coarse.marks, JumpTarget::kCollision, 0.0, 1, coarse.step_hz);
  ASSERT_TRUE(first);
  EXPECT_GT(static_cast<double>(*parts) / coarse.step_hz, *first);
}

TEST(ReplayView, ShowsTheContactsOfAPairForAQuarterOfASecond) {
  ReplayView view = plain_replay();
  view.contacts.resize(view.states.size());
  TouchPoint first;
  first.depth_m = 1.0;
  TouchPoint second;
  second.depth_m = 2.0;
  view.contacts[10] = {{{0, 1}, first}, {{0, 1}, first}};
  view.contacts[15] = {{{0, 1}, second}};
  view.contacts[20] = {{{0, 2}, first}};
  EXPECT_TRUE(contacts_at(view, 9).empty());
  EXPECT_EQ(contacts_at(view, 14).size(), 2U);
  const std::vector<FadingContact> contacts = contacts_at(view, 20);
  ASSERT_EQ(contacts.size(), 2U);  // of each pair the newest
  EXPECT_EQ(contacts[0].freshness, 1.0);
  EXPECT_EQ(contacts[1].touch.depth_m, 2.0);
  EXPECT_DOUBLE_EQ(contacts[1].freshness, 1.0 - 5.0 / 25.0);
  EXPECT_EQ(contacts_at(view, 44).size(), 1U);
  EXPECT_TRUE(contacts_at(view, 45).empty());
}

}  // namespace impetus::viewer_parts_test
