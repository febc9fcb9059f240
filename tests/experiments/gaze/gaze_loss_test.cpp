// Gaze that is lost during trials, or imposed to be late: recorded, shown, dealt with as told.
// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_loss.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/numerics/random_stream.hpp"
#include "tests/experiments/calibration_lab.hpp"

namespace impetus::gaze_loss_test {

constexpr std::int64_t kMs = 1'000'000;

/// Millisecond by millisecond: known while the last sample is valid and no older than 100 ms, or
/// within 100 ms before the first, if that is valid.
double share_by_brute_force(const std::vector<GazeSample>& samples, std::int64_t until_ms) {
  std::int64_t lost = 0;
  for (std::int64_t ms = 0; ms < until_ms; ++ms) {
    const std::int64_t now_ns = ms * kMs;
    const GazeSample* last = nullptr;
    for (const GazeSample& sample : samples) {
      last = sample.taken_ns <= now_ns ? &sample : last;
    }
    const bool before_first = last == nullptr && !samples.empty() && samples.front().at &&
                              samples.front().taken_ns - now_ns <= 100 * kMs;
    const bool known = last != nullptr && last->at && now_ns - last->taken_ns < 100 * kMs;
    lost += known || before_first ? 0 : 1;
  }
  return static_cast<double>(lost) / static_cast<double>(until_ms);
}

TEST(GazeLoss, TheShareIsThatOfEveryMillisecond) {
  constexpr std::uint64_t kSeed = 5;
  RandomStream random(kSeed, "losses");
  for (int round = 0; round < 300; ++round) {
    std::vector<GazeSample> samples;
    std::int64_t at_ms = static_cast<std::int64_t>(random.below(150));
    while (at_ms < 1000 && random.uniform() < 0.95) {
      const Fixation place = random.uniform() < 0.6 ? Fixation({0.0, 0.0}) : std::nullopt;
      samples.push_back({at_ms * kMs, place, place ? GazeLoss::kNone : GazeLoss::kBlink});
      at_ms += 1 + static_cast<std::int64_t>(random.below(180));
    }
    EXPECT_NEAR(*gaze_lost_share(samples, 0, 1000 * kMs), share_by_brute_force(samples, 1000),
                1e-12)
        << "seed " << kSeed << ", round " << round;
  }
}

TEST(GazeLoss, NothingAtAllIsAllLostAndNoTimeHasNoShare) {
  EXPECT_EQ(gaze_lost_share({}, 0, kMs), 1.0);
  EXPECT_EQ(gaze_lost_share({}, kMs, kMs), std::nullopt);
}

// ---------------------------------------------------------------- sessions

Protocol study_where_lost(const std::string& then) {
  return short_gaze_study([&](json& protocol, json&) {
    protocol["gaze"].erase("calibration");
    protocol["gaze"]["when_lost"] = {{"most_lost_share", 0.5}, {"then", then}, {"most_repeats", 2}};
  });
}

/// A gaze that is lost in the first `lost_attempts` attempts.
struct LossLab : CalibrationLab {
  LossLab(const std::string& then, std::size_t lost_attempts)
      : CalibrationLab(study_where_lost(then)) {
    eye.fault = [this, lost_attempts](const ScreenPoint& at) {
      return recorder.attempts.size() < lost_attempts ? std::nullopt : Fixation(at);
    };
  }
};

TEST(GazeLoss, ALostTrialIsShownAgainAndThenKept) {
  LossLab lab("repeat", 1);
  const SessionResult result = lab.run();
  EXPECT_EQ(result.ending, SessionEnding::kFinished);
  const auto& attempts = lab.recorder.attempts;
  ASSERT_EQ(attempts.size(), 5U);
  EXPECT_EQ(attempts[0].outcome, AttemptOutcome::kInterrupted);
  EXPECT_EQ(attempts[0].interrupted_by, "gaze lost");
  EXPECT_EQ(attempts[0].gaze_lost_share, 1.0);
  EXPECT_TRUE(attempts[0].ratings.empty());
  EXPECT_GT(attempts[0].steps.size(), 40U);
  EXPECT_EQ(attempts[1].slot, attempts[0].slot);
  EXPECT_EQ(attempts[1].number, 2);
  EXPECT_EQ(attempts[1].outcome, AttemptOutcome::kCompleted);
  EXPECT_EQ(attempts[1].interrupted_by, "");
  EXPECT_EQ(attempts[1].gaze_lost_share, 0.0);
  EXPECT_EQ(lab.titled("That one is shown once more"), 1);
  EXPECT_EQ(result.gaze.repeated_trials, 1);
  EXPECT_EQ(result.gaze.lost_trials, 0);
}

TEST(GazeLoss, AfterTheMostRepeatsItIsKeptAndMarked) {
  LossLab lab("repeat", 3);
  const SessionResult result = lab.run();
  const auto& attempts = lab.recorder.attempts;
  ASSERT_EQ(attempts.size(), 6U);
  EXPECT_EQ(attempts[1].interrupted_by, "gaze lost");
  EXPECT_EQ(attempts[2].outcome, AttemptOutcome::kCompleted);
  EXPECT_EQ(attempts[2].gaze_lost_share, 1.0);
  EXPECT_EQ(result.gaze.repeated_trials, 2);
  EXPECT_EQ(result.gaze.lost_trials, 1);
  ASSERT_EQ(lab.noted("gaze lost"), 1);
  EXPECT_EQ(lab.recorder.notes.front().text, "trial 1, attempt 3: 100 % of the stimulus");
}

TEST(GazeLoss, MarkedTrialsAreMarkedAndKeptOnesAreNot) {
  LossLab marked("mark", 2);
  EXPECT_EQ(marked.run().gaze.lost_trials, 2);
  EXPECT_EQ(marked.recorder.attempts.size(), 4U);
  EXPECT_EQ(marked.noted("gaze lost"), 2);
  LossLab kept("keep", 2);
  EXPECT_EQ(kept.run().gaze.lost_trials, 0);
  EXPECT_EQ(kept.noted("gaze lost"), 0);
  EXPECT_EQ(kept.recorder.attempts[0].gaze_lost_share, 1.0);
}

TEST(GazeLoss, TheMarkStandsInTheIntervalAfterwardsAlone) {
  LossLab lab("mark", 1);
  lab.run();
  std::size_t marks = 0;
  for (const Picture& picture : lab.display.pictures) {
    const bool interval = picture.bodies.empty() && !picture.fixation_cross;
    marks += picture.progress.gaze_was_lost ? 1 : 0;
    EXPECT_TRUE(interval || !picture.progress.gaze_was_lost);
  }
  EXPECT_EQ(marks, 42U);  // 700 ms at 60 Hz
}

TEST(GazeLoss, WhatInterruptsATrialIsRecorded) {
  LossLab lab("mark", 0);
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 80 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  lab.run();
  EXPECT_EQ(lab.recorder.attempts[0].interrupted_by, "pause");
  EXPECT_GT(*lab.recorder.attempts[0].gaze_lost_share, -1e-9);
  LossLab closed("mark", 0);
  closed.input.on_frame = [](std::int64_t frame) {
    return frame == 80 ? Interruption::kDisplayClosed : Interruption::kNone;
  };
  closed.run();
  EXPECT_EQ(closed.recorder.attempts[0].interrupted_by, "display closed");
}

// ---------------------------------------------------------------- imposed latency

TEST(GazeLatency, TheScenesLatencyIsAFactorAndAddsToTheProtocols) {
  CalibrationLab lab(short_gaze_study([](json& protocol, json& scene) {
    scene["imposed"]["gaze_latency_ms"] = 0;
    protocol["gaze"].erase("calibration");
    protocol["gaze"]["extra_latency_ms"] = 20;
    protocol["design"]["factors"][1] = {
        {"name", "latency"}, {"pointer", "/imposed/gaze_latency_ms"}, {"levels", {0, 80}}};
  }));
  lab.run();
  ASSERT_EQ(lab.recorder.attempts.size(), 8U);
  for (const AttemptRecord& attempt : lab.recorder.attempts) {
    const PlannedTrial& trial = lab.plan[static_cast<std::size_t>(attempt.slot) - 1];
    const double latency_s = 0.02 + std::get<double>(trial.condition[1].value) / 1e3;
    EXPECT_DOUBLE_EQ(*attempt.imposed_gaze_latency_s, latency_s);
    for (std::size_t step = 1; step < attempt.steps.size(); ++step) {
      const double age_s = static_cast<double>(attempt.steps[step].gaze.age_ns) / 1e9;
      EXPECT_GE(age_s, latency_s - 1e-9);
      EXPECT_LT(age_s, latency_s + 0.0101);  // a sample every 10 ms
    }
  }
}

TEST(GazeLatency, WithoutAGazeNoneIsImposed) {
  CalibrationLab lab;
  lab.gaze = nullptr;
  lab.run();
  EXPECT_EQ(lab.recorder.attempts[0].imposed_gaze_latency_s, std::nullopt);
  EXPECT_EQ(lab.recorder.attempts[0].gaze_lost_share, std::nullopt);
  EXPECT_TRUE(lab.recorder.calibrations.empty());
}

}  // namespace impetus::gaze_loss_test
