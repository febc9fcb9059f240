// What the views say of a trial of two intervals: each row tells its own, and counts from its
// onset.
// SPDX-License-Identifier: MIT
#include "tests/experiments/test_study.hpp"

namespace impetus::interval_views_test {

constexpr std::int64_t kBetween_ns = 21'000'000'000;  // from the one onset to the other
constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// A recorded attempt whose stimulus is shown again. In the first stimulus there are clicks 500 and
/// 750 ms after its onset, in the second 250 ms after its own; samples of the gaze 4 ms before and
/// 8 ms after each onset; in each one step 7 that popped, with a known fixation.
AttemptRecord two_intervals() {
  AttemptRecord attempt = recorded_attempts()[0];
  attempt.steps[7].pops = 1;
  attempt.steps[7].gaze.fixation = ScreenPoint{0.1, -0.2};
  const std::size_t frames = attempt.frames.size();
  const std::size_t steps = attempt.steps.size();
  for (std::size_t i = 0; i < frames; ++i) {
    FrameRecord again = attempt.frames[i];
    again.frame += static_cast<std::int64_t>(frames);
    again.flip.flipped_ns += kBetween_ns;
    again.interval = 2;
    attempt.frames.push_back(again);
  }
  for (std::size_t i = 0; i < steps; ++i) {
    StepRecord again = attempt.steps[i];
    again.shown_frame += again.shown_frame < 0 ? 0 : static_cast<std::int64_t>(frames);
    again.interval = 2;
    attempt.steps.push_back(again);
  }
  const std::int64_t first_ns = attempt.onset_ns;
  const std::int64_t second_ns = first_ns + kBetween_ns;
  attempt.clicks = {{"mouse", first_ns + 500 * kMillisecond_ns, 0, 1},
                    {"mouse", first_ns + 750 * kMillisecond_ns, 0, 1},
                    {"mouse", second_ns + 250 * kMillisecond_ns, 0, 2}};
  attempt.gaze_source = "mouse";
  for (const auto& [onset_ns, interval] : {std::pair(first_ns, 1), std::pair(second_ns, 2)}) {
    attempt.gaze.push_back(
        {onset_ns - 4 * kMillisecond_ns, ScreenPoint{}, GazeLoss::kNone, interval});
    attempt.gaze.push_back(
        {onset_ns + 8 * kMillisecond_ns, ScreenPoint{}, GazeLoss::kNone, interval});
  }
  return attempt;
}

/// A study of this attempt alone, of a protocol that asks for clicks.
class IntervalViews : public testing::Test {
 protected:
  void save(const AttemptRecord& attempt, bool keeps_steps = true) {
    EnrolledStudy at(path_);
    StudyWriter writer(at.study, at.enrolment, facts());
    if (!keeps_steps) {
      writer.keep_no_steps();
    }
    writer.save(attempt);
    writer.end("quit");
    at.study.database().exec(
        "UPDATE protocol SET protocol_json = json_set(protocol_json, '$.clicks', json('{}'))");
  }

  [[nodiscard]] std::string asked(const std::string& sql) const { return value_of(path_, sql); }

  TemporaryFolder folder_;
  std::string path_{(folder_ / "a.sqlite").string()};
};

constexpr const char* kClicks =
    "SELECT group_concat(interval || ': ' || time_s, ', ') FROM trial_click";
constexpr const char* kSamples =
    "SELECT group_concat(interval || ': ' || time_s, ', ') FROM gaze_sample";

TEST_F(IntervalViews, ClicksAndGazeCountFromTheOnsetOfTheirOwnStimulus) {
  save(two_intervals());
  EXPECT_EQ(asked(kClicks), "1: 0.5, 1: 0.75, 2: 0.25");
  EXPECT_EQ(asked(kSamples), "1: -0.004, 1: 0.008, 2: -0.004, 2: 0.008");
}

TEST_F(IntervalViews, TheyDoSoWithoutSteps) {
  save(two_intervals(), /*keeps_steps=*/false);
  EXPECT_EQ(asked("SELECT count(*) FROM step"), "0");
  EXPECT_EQ(asked(kClicks), "1: 0.5, 1: 0.75, 2: 0.25");
  EXPECT_EQ(asked(kSamples), "1: -0.004, 1: 0.008, 2: -0.004, 2: 0.008");
}

TEST_F(IntervalViews, WithoutFramesOfTheSecondStimulusItsTimesAreNotKnown) {
  AttemptRecord attempt = two_intervals();
  attempt.frames.resize(attempt.frames.size() / 2);
  save(attempt);
  EXPECT_EQ(asked("SELECT group_concat(interval || ': ' || ifnull(time_s, 'not known'), ', ') "
                  "FROM trial_click"),
            "1: 0.5, 1: 0.75, 2: not known");
}

TEST_F(IntervalViews, AStepOfEachNumberIsOfOneInterval) {
  save(two_intervals());
  const std::string frames = std::to_string(recorded_attempts()[0].frames.size());
  for (const std::string view : {"gaze_step", "popped_step"}) {
    EXPECT_EQ(asked("SELECT group_concat(interval || ': ' || step, ', ') FROM " + view),
              "1: 7, 2: 7")
        << view;
    EXPECT_EQ(asked("SELECT max(shown_frame) FILTER (WHERE interval = 2) - "
                    "max(shown_frame) FILTER (WHERE interval = 1) FROM " +
                    view),
              frames)
        << view;
  }
}

TEST_F(IntervalViews, TheExposureOfATrialIsThatOfAllItsClicks) {
  save(two_intervals());
  EXPECT_EQ(asked("SELECT clicks FROM click_trial"), "3");
  EXPECT_EQ(asked("SELECT exposure_s = 2 * (SELECT max(shown_time_s) FROM frame) FROM click_trial"),
            "1");
  EXPECT_EQ(asked("SELECT first_click_s FROM click_trial"), "0.5");
}

TEST_F(IntervalViews, AFirstClickInTheSecondStimulusIsTimedInIt) {
  AttemptRecord attempt = two_intervals();
  attempt.clicks.erase(attempt.clicks.begin(), attempt.clicks.begin() + 2);
  save(attempt);
  EXPECT_EQ(asked("SELECT first_click_s FROM click_trial"), "0.25");
}

TEST_F(IntervalViews, ATrialOfOneStimulusCountsAsItDid) {
  AttemptRecord attempt = recorded_attempts()[0];
  attempt.clicks = {{"mouse", attempt.onset_ns + 500 * kMillisecond_ns, 0, 1}};
  save(attempt);
  EXPECT_EQ(asked(kClicks), "1: 0.5");
  EXPECT_EQ(
      asked("SELECT exposure_s = (SELECT max(shown_time_s) FROM frame) AND first_click_s = 0.5 "
            "FROM click_trial"),
      "1");
}

TEST_F(IntervalViews, WithoutFramesTheExposureIsNotKnown) {
  AttemptRecord attempt = two_intervals();
  attempt.frames.clear();
  save(attempt);
  EXPECT_EQ(asked("SELECT exposure_s IS NULL FROM click_trial"), "1");
}

}  // namespace impetus::interval_views_test
