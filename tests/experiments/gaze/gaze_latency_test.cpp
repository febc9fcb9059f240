// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_latency.hpp"

#include <gtest/gtest.h>

namespace impetus::gaze_latency_test {

constexpr std::int64_t kMs = 1'000'000;

GazeSample seen_at(std::int64_t taken_ms) {
  return {taken_ms * kMs, ScreenPoint{0.0, 0.0}, GazeLoss::kNone};
}

GazeSample blink_at(std::int64_t taken_ms) {
  return {taken_ms * kMs, std::nullopt, GazeLoss::kBlink};
}

/// A step computed at `at_ms` from the sample taken at `taken_ms`, first shown by `frame`.
StepRecord step_at(std::int64_t at_ms, std::int64_t taken_ms, std::int64_t frame) {
  StepRecord step;
  step.gaze.fixation = ScreenPoint{0.0, 0.0};
  step.gaze.taken_ns = taken_ms * kMs;
  step.gaze.age_ns = (at_ms - taken_ms) * kMs;
  step.shown_frame = frame;
  return step;
}

FrameRecord flipped_at(std::int64_t flipped_ms) {
  FrameRecord frame;
  frame.flip.flipped_ns = flipped_ms * kMs;
  return frame;
}

/// Steps whose samples took 1, 2, ... `count` ms to the flip; the slowest comes first.
struct Countdown {
  explicit Countdown(std::int64_t count) {
    for (std::int64_t latency_ms = count; latency_ms >= 1; --latency_ms) {
      const std::int64_t taken_ms = 1000 * (count - latency_ms + 1);
      samples.push_back(seen_at(taken_ms));
      steps.push_back(step_at(taken_ms, taken_ms, static_cast<std::int64_t>(frames.size())));
      frames.push_back(flipped_at(taken_ms + latency_ms));
    }
  }
  std::vector<GazeSample> samples;
  std::vector<StepRecord> steps;
  std::vector<FrameRecord> frames;
};

double p95_of(const Countdown& shown) {
  return gaze_latency_p95_ms(shown.steps, shown.frames, shown.samples).value();
}

TEST(GazeLatency, SilenceOfATrackerIsLatencyWhatItsMarkSays) {
  Countdown shown(1);
  shown.steps.front() = step_at(1300, 1000, 0);
  shown.frames.front() = flipped_at(1310);
  shown.samples.push_back(blink_at(1001));
  EXPECT_EQ(gaze_latencies_ms(shown.steps, shown.frames, shown.samples), std::vector<double>{});
  shown.samples.back().taken_ns = 1000 * kMs + kSilentAfter_ns;
  EXPECT_EQ(p95_of(shown), 310.0);
}

TEST(GazeLatency, The95thPercentileIsTheNearestRank) {
  // rank ⌈.95 n⌉: of 1, the 1st; of 10, ⌈9.5⌉; of 20, 19; of 21, ⌈19.95⌉; of 100, 95.
  EXPECT_EQ(p95_of(Countdown(1)), 1.0);
  EXPECT_EQ(p95_of(Countdown(10)), 10.0);
  EXPECT_EQ(p95_of(Countdown(20)), 19.0);
  EXPECT_EQ(p95_of(Countdown(21)), 20.0);
  EXPECT_EQ(p95_of(Countdown(100)), 95.0);
}

TEST(GazeLatency, StepsWithoutAGazeOrAFrameDoNotCount) {
  StepRecord blind = step_at(10, 0, 0);
  blind.gaze.fixation.reset();
  const StepRecord never_shown = step_at(10, 0, -1);
  EXPECT_FALSE(gaze_latency_p95_ms({}, {}, {}));
  EXPECT_FALSE(gaze_latency_p95_ms({blind, never_shown}, {flipped_at(50)}, {seen_at(0)}));
}

TEST(GazeLatency, ABlinkAgesTheSampleButIsNoLatency) {
  // Samples at 0, 4, 8, ...; those at 20 to 160 are lost. Flips come 26 ms after a step.
  std::vector<GazeSample> samples;
  for (std::int64_t taken_ms = 0; taken_ms <= 200; taken_ms += 4) {
    const bool open = taken_ms < 20 || taken_ms > 160;
    samples.push_back(open ? seen_at(taken_ms) : blink_at(taken_ms));
  }
  const std::vector<FrameRecord> frames{flipped_at(44), flipped_at(126), flipped_at(196)};
  const StepRecord before = step_at(18, 16, 0);   // 28 ms
  const StepRecord amid = step_at(100, 16, 1);    // 110 ms, for the eye is closed
  const StepRecord after = step_at(170, 168, 2);  // 28 ms
  EXPECT_EQ(gaze_latency_p95_ms({before, amid, after}, frames, samples), 28.0);
  EXPECT_FALSE(gaze_latency_p95_ms({amid}, frames, samples));
}

TEST(GazeLatency, AStepBeforeTheLossCounts) {
  // The next sample is lost, but later than the step, which could not have used it anyway.
  const std::vector<GazeSample> samples{seen_at(0), blink_at(30)};
  const std::vector<FrameRecord> frames{flipped_at(40)};
  EXPECT_EQ(gaze_latency_p95_ms({step_at(29, 0, 0)}, frames, samples), 40.0);
  EXPECT_FALSE(gaze_latency_p95_ms({step_at(30, 0, 0)}, frames, samples));
}

TEST(GazeLatency, ASampleThatCameTooLateIsLatency) {
  // Newer samples were taken in time and seen, but were not used: the tracker or an imposed latency
  // held them back. A loss after them does not excuse it.
  const std::vector<GazeSample> samples{seen_at(0), seen_at(4), blink_at(8)};
  EXPECT_EQ(gaze_latency_p95_ms({step_at(70, 0, 0)}, {flipped_at(90)}, samples), 90.0);
}

TEST(GazeLatency, SamplesThatStopComingAreLatency) {
  EXPECT_EQ(gaze_latency_p95_ms({step_at(500, 0, 0)}, {flipped_at(520)}, {seen_at(0)}), 520.0);
}

TEST(GazeLatency, ASampleFromBeforeTheStimulusIsFollowedByTheFirstRecorded) {
  const std::vector<FrameRecord> frames{flipped_at(120)};
  EXPECT_FALSE(gaze_latency_p95_ms({step_at(100, 10, 0)}, frames, {blink_at(50)}));
  EXPECT_EQ(gaze_latency_p95_ms({step_at(100, 10, 0)}, frames, {seen_at(50)}), 110.0);
}

}  // namespace impetus::gaze_latency_test
