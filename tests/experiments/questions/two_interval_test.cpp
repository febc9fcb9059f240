// Two stimuli in one trial: their order, what is recorded of each, and which choice is right.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/questions/two_interval.hpp"
#include "experiments/run/replay.hpp"
#include "tests/experiments/asked_study.hpp"

namespace impetus::two_interval_test {

struct TwoIntervalLab : TestLab {
  TwoIntervalLab() : TestLab(60.0, asked({kAskTwoInterval, kAskClicks})) {}

  AttemptRecord run(std::uint64_t seed, std::size_t choice = 0) {
    return answered_trial(*this, trial_with_delay(300, seed), choice);
  }
};

/// The interval in which something froze; each has one collision.
std::int64_t delayed_interval(const AttemptRecord& record) {
  EXPECT_EQ(record.collisions.size(), 2U);
  const auto delayed = std::find_if(
      record.collisions.begin(), record.collisions.end(),
      [](const CollisionRecord& collision) { return collision.report.imposed_hold_s > 0.0; });
  return delayed == record.collisions.end() ? 0 : delayed->interval;
}

TEST(TwoInterval, TheConditionsOwnStimulusIsInTheIntervalThatTheSeedDecides) {
  TwoIntervalLab lab;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const AttemptRecord record = lab.run(seed);
    const std::int64_t own = test_interval(lab.protocol.script, trial_with_delay(300, seed));
    EXPECT_EQ(delayed_interval(record), own) << "seed " << seed;
    EXPECT_EQ(record.responses.front().detail,
              (std::vector<FactorLevel>{{"test_interval", static_cast<double>(own)}}));
  }
}

TEST(TwoInterval, BothOrdersComeEquallyOften) {
  const Script script = asked({kAskTwoInterval}).script;
  int first = 0;
  constexpr int kTrials = 2000;
  for (int seed = 0; seed < kTrials; ++seed) {
    first += test_interval(script, trial_with_delay(0, static_cast<std::uint64_t>(seed))) == 1;
  }
  EXPECT_NEAR(first, kTrials / 2, 4 * 22.4);  // standard deviation √(2000 · ¼)
}

// Recorded studies replay by it: a change here would show other stimuli.
TEST(TwoInterval, TheOrderIsAsWhenItWasFirstReleased) {
  const Script script = asked({kAskTwoInterval}).script;
  std::string order;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    order += std::to_string(test_interval(script, trial_with_delay(0, seed)));
  }
  EXPECT_EQ(order, "112122122111212122222221");
}

TEST(TwoInterval, ChoosingTheConditionsOwnIntervalIsPositiveAndRight) {
  TwoIntervalLab lab;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    for (const std::size_t choice : {0U, 1U}) {
      const AttemptRecord record = lab.run(seed, choice);
      const bool right = static_cast<std::int64_t>(choice) + 1 == delayed_interval(record);
      EXPECT_EQ(record.responses.front().positive, right);
      EXPECT_EQ(record.responses.front().correct, right);
      EXPECT_EQ(record.responses.front().answer, choice == 0 ? "first" : "second");
    }
  }
}

TEST(TwoInterval, EachIntervalHasACrossAndABlankLiesBetween) {
  TwoIntervalLab lab;
  lab.run(1);
  std::string seen;  // one letter for each run of equal pictures: blank, cross, scene
  std::vector<int> frames;
  for (const Picture& picture : lab.display.pictures) {
    const char kind = picture.fixation_cross ? 'c' : picture.bodies.empty() ? 'b' : 's';
    if (seen.empty() || seen.back() != kind) {
      seen += kind;
      frames.push_back(0);
    }
    ++frames.back();
  }
  EXPECT_EQ(seen, "bcsbcs");
  // 700 ms, 500 ms, scene, 500 ms (between), 500 ms at 60 Hz; a scene of .2 s, or .5 s with delay.
  EXPECT_EQ(frames[0], 42);
  EXPECT_EQ(frames[1], 30);
  EXPECT_EQ(frames[3], 30);
  EXPECT_EQ(frames[4], 30);
  EXPECT_EQ(std::min(frames[2], frames[5]), 13);
  EXPECT_EQ(std::max(frames[2], frames[5]), 31);
}

TEST(TwoInterval, FramesAreNumberedThroughAndStepsPointToThoseOfTheirInterval) {
  TwoIntervalLab lab;
  const AttemptRecord record = lab.run(2);
  for (std::size_t i = 0; i < record.frames.size(); ++i) {
    ASSERT_EQ(record.frames[i].frame, static_cast<std::int64_t>(i));
    ASSERT_GE(record.frames[i].interval, i == 0 ? 1 : record.frames[i - 1].interval);
  }
  std::int64_t in_second = 0;
  for (const StepRecord& step : record.steps) {
    ASSERT_GE(step.shown_frame, 0);
    const FrameRecord& frame = record.frames[static_cast<std::size_t>(step.shown_frame)];
    ASSERT_EQ(frame.interval, step.interval);
    ASSERT_EQ(frame.phase, FramePhase::kStimulus);
    // The first frame at or after the step's time: less than a frame later.
    const double late_s = frame.shown_time_s - static_cast<double>(step.step) / 240.0;
    ASSERT_GE(late_s, -1e-9);
    ASSERT_LT(late_s, 1.0 / 60.0 - 1e-9);
    in_second += step.interval == 2 ? 1 : 0;
  }
  EXPECT_GT(in_second, 0);
  EXPECT_GT(std::ssize(record.steps), in_second);
}

TEST(TwoInterval, EachIntervalsStepsReplayInItsOwnScene) {
  TwoIntervalLab lab;
  const PlannedTrial trial = trial_with_delay(300, 3);
  const AttemptRecord record = lab.run(3);
  std::int64_t interval = 0;
  for (const PlannedTrial& shown : stimuli_of(lab.protocol.script, trial)) {
    ++interval;
    std::vector<StepRecord> steps;
    std::copy_if(record.steps.begin(), record.steps.end(), std::back_inserter(steps),
                 [&](const StepRecord& step) { return step.interval == interval; });
    const auto result = replay(lab.scenes.stage(shown, lab.display.geometry()), steps);
    EXPECT_FALSE(result.divergence);
    EXPECT_EQ(result.steps, std::ssize(steps) - 1);
  }
  EXPECT_EQ(interval, 2);
}

TEST(TwoInterval, ClicksBelongToTheIntervalInWhichTheyWereMade) {
  TwoIntervalLab lab;
  std::size_t clicked_at = 0;  // one click on each picture of a scene
  lab.input.on_clicks = [&]() -> std::vector<ClickRecord> {
    const std::size_t shown = lab.display.pictures.size();
    const bool clicks = shown > clicked_at && !lab.display.pictures.back().bodies.empty();
    clicked_at = shown;
    return clicks ? std::vector<ClickRecord>{{"mouse", lab.clock.now_ns(), 0}}
                  : std::vector<ClickRecord>{};
  };
  const AttemptRecord record = lab.run(1);
  for (const ClickRecord& click : record.clicks) {
    const auto frame = std::find_if(
        record.frames.rbegin(), record.frames.rend(),
        [&](const FrameRecord& one) { return one.flip.flipped_ns <= click.arrived_ns; });
    ASSERT_EQ(frame->interval, click.interval);
  }
  // One per frame of both scenes but each one's first.
  EXPECT_EQ(record.clicks.size(), 12U + 30U);
}

TEST(TwoInterval, InterruptedInTheSecondItKeepsTheFirst) {
  TwoIntervalLab lab;
  lab.input.on_frame = [](std::int64_t frame) {
    return frame == 150 ? Interruption::kPauseRequested : Interruption::kNone;
  };
  const AttemptRecord record = lab.run(1);
  EXPECT_EQ(record.outcome, AttemptOutcome::kInterrupted);
  EXPECT_TRUE(record.responses.empty());
  const auto of_first = std::count_if(record.steps.begin(), record.steps.end(),
                                      [](const StepRecord& step) { return step.interval == 1; });
  EXPECT_GT(of_first, 40);
  EXPECT_EQ(of_first, std::ssize(record.steps));  // the second had come to its cross
  EXPECT_EQ(record.frames.back().interval, 2);
  EXPECT_EQ(record.frames.back().phase, FramePhase::kFixation);
}

TEST(TwoInterval, TheStandardReplacesItsLevelsAndNothingElse) {
  const auto asked =
      TwoIntervalQuestion::rows().read({{"question", "?"}, {"standard", {{"b", 7.0}}}});
  const auto& question = dynamic_cast<const TwoIntervalQuestion&>(*asked);
  const Condition condition{{"a", 1.0}, {"b", 2.0}, {"c", std::string("x")}};
  EXPECT_EQ(question.standard(condition),
            (Condition{{"a", 1.0}, {"b", 7.0}, {"c", std::string("x")}}));
}

}  // namespace impetus::two_interval_test
