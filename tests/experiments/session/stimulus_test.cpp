// What a participant of the causality study is shown, frame by frame.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/live_run.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::stimulus_test {

constexpr double kHz = 60.0;
/// A hold runs down by one step at a time: at most 72 roundings of 0.3 s, at .15 m/s.
constexpr double kRunDown_m = 72 * 6e-17 * 0.15;
constexpr std::int64_t kContactFrame = 60;  // lead 1.0 s

Condition condition(double delay_ms, double speed_deg_s, double viewpoint_deg) {
  return {{"delay_ms", delay_ms}, {"speed_deg_s", speed_deg_s}, {"viewpoint_deg", viewpoint_deg}};
}

/// Poses of every frame of a condition.
struct Shown {
  StagedScene scene;
  std::vector<std::vector<Pose>> frames;
  std::vector<CollisionRecord> collisions;

  [[nodiscard]] double gap_m(std::size_t frame) const {
    return (frames[frame][1].position - frames[frame][0].position).norm() -
           scene.looks[0].radius_m - scene.looks[1].radius_m;
  }
  /// How far the first body came from one frame to another.
  [[nodiscard]] double moved_m(std::size_t from, std::size_t to) const {
    return (frames[to][0].position - frames[from][0].position).norm();
  }
};

Shown show(const Protocol& protocol, const Condition& of, double hz = kHz,
           bool round_to_frames = false) {
  const ProtocolScenes scenes(protocol, round_to_frames ? hz : 0.0);
  StagedScene staged = scenes.stage(of, assumed_screen());
  Shown shown{staged, {}, {}};
  LiveRun live(std::move(staged), 1);
  const auto frames = static_cast<std::int64_t>(shown.scene.duration_s * hz);
  for (std::int64_t frame = 0; frame <= frames; ++frame) {
    shown.frames.push_back(live.poses_at(static_cast<double>(frame) / hz));
  }
  shown.collisions = live.take_collisions();
  return shown;
}

double half_pixel_m() { return 0.5 * assumed_screen().width_m / assumed_screen().width_px; }

TEST(CausalityStimulus, ContactFallsOnItsFrameExactlyTouchingInEveryCell) {
  const Protocol protocol = causality();
  for (const Condition& cell : cells(protocol.design)) {
    const Shown shown = show(protocol, cell);
    // The issue asks for ± ½ pixel; the places are chosen to be within a millionth of one.
    EXPECT_LT(std::abs(shown.gap_m(kContactFrame)), 1e-6 * half_pixel_m());
    EXPECT_GT(shown.gap_m(kContactFrame - 1), half_pixel_m());
    ASSERT_EQ(shown.collisions.size(), 1U);
    EXPECT_EQ(shown.collisions[0].step, 240);
    EXPECT_LT(shown.collisions[0].report.contact.touch.point.norm(), 1e-12);
  }
}

TEST(CausalityStimulus, TheFreezeLastsItsWholeFramesAndNoMore) {
  const Protocol protocol = causality();
  for (const auto& [delay_ms, frames] : {std::pair{0.0, 0}, {100.0, 6}, {300.0, 18}}) {
    const Shown shown = show(protocol, condition(delay_ms, 10, 0));
    const std::size_t release = kContactFrame + static_cast<std::size_t>(frames);
    for (std::size_t frame = kContactFrame; frame <= release; ++frame) {
      EXPECT_LT(shown.moved_m(kContactFrame, frame), kRunDown_m);
    }
    EXPECT_GT(shown.gap_m(release + 1), half_pixel_m()) << delay_ms;
    EXPECT_EQ(shown.collisions[0].report.imposed_hold_s, delay_ms / 1e3);
  }
}

TEST(CausalityStimulus, SpheresReboundWithEqualAndOppositeVelocities) {
  const Shown shown = show(causality(), condition(100, 15, 0));
  const auto last = shown.frames.size() - 1;
  const Vector3 in = shown.frames[1][0].position - shown.frames[0][0].position;
  const Vector3 out = shown.frames[last][0].position - shown.frames[last - 1][0].position;
  // Four steps of rounding in positions of 0.16 m.
  EXPECT_LT((in + out).norm(), 1e-15);
  EXPECT_EQ(shown.frames[last][0].position.x(), -shown.frames[last][1].position.x());
}

TEST(CausalityStimulus, SpeedIsInDegreesPerSecondAtTheScreensCentre) {
  const Shown shown = show(causality(), condition(0, 10, 0));
  const double way_m = (shown.frames[60][0].position - shown.frames[0][0].position).norm();
  const double m_per_deg = metres_per_degree(assumed_screen().viewing_distance_m);
  EXPECT_NEAR(way_m / m_per_deg, 10.0, 1e-9);
  EXPECT_NEAR(shown.scene.looks[0].radius_m / m_per_deg, 1.0, 1e-12);
}

TEST(CausalityStimulus, ViewpointMovesTheViewerAndNotTheWorld) {
  const Protocol protocol = causality();
  const Shown front = show(protocol, condition(100, 10, 0));
  const Shown side = show(protocol, condition(100, 10, 85));
  ASSERT_EQ(front.frames.size(), side.frames.size());
  for (std::size_t frame = 0; frame < front.frames.size(); ++frame) {
    ASSERT_EQ(front.frames[frame][0].position, side.frames[frame][0].position);
  }
  // The angle between the line of approach (x) and the image plane is that between x and `right`.
  EXPECT_NEAR(std::acos(side.scene.viewer.right.x()) * 180.0 / std::acos(-1.0), 85.0, 1e-9);
}

TEST(CausalityStimulus, A100HzDisplayShowsTenAndThirtyFrames) {
  const Protocol protocol = causality();
  for (const auto& [delay_ms, frames] : {std::pair{100.0, 10}, {300.0, 30}}) {
    const Shown shown = show(protocol, condition(delay_ms, 10, 0), 100.0);
    const std::size_t release = 100 + static_cast<std::size_t>(frames);
    EXPECT_LT(shown.moved_m(100, release), kRunDown_m);
    EXPECT_GT(shown.gap_m(release + 1), half_pixel_m());
  }
}

// 100 ms is 8.5 frames at 85 Hz: rounded to 9, 105.88 ms, which ends within a step of 1/240 s.
TEST(CausalityStimulus, ARoundedFreezeEndsOnItsFrameThoughNotOnAStep) {
  const Shown shown = show(causality(), condition(100, 10, 0), 85.0, /*round_to_frames=*/true);
  EXPECT_NEAR(shown.scene.realised_hold_s, 9.0 / 85.0, 1e-15);
  EXPECT_EQ(shown.scene.intended_hold_s, 0.1);
  const std::size_t contact = 85;
  EXPECT_LT(shown.moved_m(contact, contact + 9), kRunDown_m);
  const double frame_way_m = 0.0994863 / 85.0;
  EXPECT_NEAR(shown.moved_m(contact, contact + 10), frame_way_m, 1e-3 * frame_way_m);
}

TEST(CausalityStimulus, EveryParticipantSeesTheSameFrames) {
  TestLab one;
  TestLab other;
  const Plan plan = short_plan(one.protocol, 2);
  run_session(one.protocol.script, plan, {}, one.ports());
  run_session(other.protocol.script, plan, {}, other.ports());
  ASSERT_EQ(one.display.pictures.size(), other.display.pictures.size());
  for (std::size_t i = 0; i < one.display.pictures.size(); ++i) {
    ASSERT_EQ(one.display.pictures[i].bodies.size(), other.display.pictures[i].bodies.size());
    for (std::size_t body = 0; body < one.display.pictures[i].bodies.size(); ++body) {
      ASSERT_EQ(one.display.pictures[i].bodies[body].pose.position,
                other.display.pictures[i].bodies[body].pose.position);
    }
  }
}

TEST(CausalityStimulus, TheFirstFrameThatShowedTheContactIsRecorded) {
  TestLab lab;
  run_session(lab.protocol.script, short_plan(lab.protocol, 1), {}, lab.ports());
  for (const AttemptRecord& attempt : lab.recorder.attempts) {
    ASSERT_EQ(attempt.collisions.size(), 1U);
    EXPECT_EQ(attempt.collisions[0].first_frame_shown, kContactFrame);
    EXPECT_EQ(attempt.frames.size(), 30U + 121U + std::lround(attempt.realised_hold_s * kHz));
  }
}

}  // namespace impetus::stimulus_test
