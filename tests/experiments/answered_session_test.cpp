// Whole sessions of studies that ask each kind of question: consent to thanks, with a simulated
// participant, stored, and replayed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::answered_session_test {

/// Runs S01 through a study that asks these questions, into study.sqlite.
ProgramResult run_asked(const TemporaryFolder& folder, const std::vector<std::string>& questions,
                        const std::string& observer = "causality") {
  json protocol = asked_protocol(questions);
  protocol["scene"] = "scene.json";
  folder.write("asked.json", protocol.dump());
  folder.write("scene.json", asked_scene().dump());
  const std::string file = source_file("experiments/observers/" + observer + ".json").string();
  return run_program(folder, {"run", "asked.json", "--db", "study.sqlite", "--observer", file,
                              "--participants", "1"});
}

std::string counted(const TemporaryFolder& folder, const std::string& what) {
  return value_of(folder / "study.sqlite", "SELECT count(*) FROM " + what);
}

/// Both practice trials and the four main ones, all replayed as they were.
void expect_whole_session(const TemporaryFolder& folder, const ProgramResult& run,
                          const std::string& trials = "6") {
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(counted(folder, "enrolment WHERE finished_utc IS NOT NULL"), "1");
  EXPECT_EQ(counted(folder, "attempt WHERE outcome = 'completed'"), trials);
  EXPECT_EQ(counted(folder, "answer WHERE kind = 'consent' AND answer = 'agreed'"), "1");
  const ProgramResult replayed = run_program(folder, {"replay", "study.sqlite"});
  EXPECT_EQ(replayed.status, 0) << replayed.output;
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
}

TEST(AnsweredSession, OfRatingsRunsAndReplays) {
  const TemporaryFolder folder;
  expect_whole_session(folder, run_asked(folder, {kAskRating}));
  EXPECT_EQ(counted(folder, "rated_trial"), "6");
  EXPECT_EQ(counted(folder, "trial_response"), "0");
}

TEST(AnsweredSession, OfYesOrNoRunsAndReplays) {
  const TemporaryFolder folder;
  expect_whole_session(folder, run_asked(folder, {kAskYesNo}));
  EXPECT_EQ(counted(folder,
                    "trial_response WHERE kind = 'yes_no' AND device = 'simulated' AND "
                    "answer = iif(positive, 'yes', 'no') AND detail = '{}' AND "
                    "correct = (positive = (condition ->> '$.delay_ms' > 0))"),
            "6");
  EXPECT_EQ(counted(folder, "rating"), "0");
}

TEST(AnsweredSession, OfTwoIntervalsRunsAndReplaysBoth) {
  const TemporaryFolder folder;
  expect_whole_session(folder, run_asked(folder, {kAskTwoInterval}));
  EXPECT_EQ(counted(folder,
                    "trial_response WHERE kind = 'two_interval' AND positive = correct AND "
                    "positive = (answer = iif(detail ->> '$.test_interval' = 1, 'first', "
                    "'second'))"),
            "6");
  // One collision in each interval; of a condition with a delay, the one in the test interval has
  // it.
  EXPECT_EQ(counted(folder, "collision"), "12");
  EXPECT_EQ(counted(folder,
                    "collision JOIN response USING (attempt_id) WHERE imposed_hold_ms > 0 "
                    "AND interval = detail ->> '$.test_interval'"),
            "3");
  EXPECT_EQ(counted(folder, "collision WHERE imposed_hold_ms > 0"), "3");
  const std::string steps = counted(folder, "step WHERE step > 0");
  EXPECT_NE(run_program(folder, {"replay", "study.sqlite"}).output.find(steps + " steps"),
            std::string::npos);
  const ProgramResult truth = run_program(folder, {"replay", "study.sqlite", "--truth"});
  EXPECT_EQ(truth.output, "12 collisions measured in 6 trials\n");
}

TEST(AnsweredSession, OfTwoIntervalsAdaptsByOneStimulusATrial) {
  const TemporaryFolder folder;
  const char* kAdapting = R"({"design": {"adaptation": [{"when": {"delay_ms": 300},
    "conditions": [{"delay_ms": 300}], "first": 8, "before_each": 2}]}})";
  expect_whole_session(folder, run_asked(folder, {kAskTwoInterval, kAdapting}), "16");
  const std::string adapting =
      "attempt JOIN trial ON trial.id = trial_id WHERE phase = 'adaptation'";
  EXPECT_EQ(counted(folder, adapting), "10");
  EXPECT_EQ(counted(folder, adapting + " AND intended_hold_ms = 300 AND realised_hold_ms = 300"),
            "10");
  EXPECT_EQ(counted(folder,
                    "step JOIN attempt ON attempt.id = attempt_id JOIN trial ON trial.id = "
                    "trial_id WHERE phase = 'adaptation' AND interval > 1"),
            "0");
}

TEST(AnsweredSession, OfFreeWordsRunsAndReplays) {
  const TemporaryFolder folder;
  expect_whole_session(folder, run_asked(folder, {kAskFreeText}));
  EXPECT_EQ(counted(folder,
                    "trial_response WHERE kind = 'free_text' AND answer IS NULL AND "
                    "positive IS NULL AND correct IS NULL AND timed_out = 0"),
            "6");
}

TEST(AnsweredSession, OfClicksInTwoIntervalsRunsAndReplays) {
  const TemporaryFolder folder;
  expect_whole_session(folder, run_asked(folder, {kAskClicks, kAskTwoInterval}, "gaze-contingent"));
  // Each click arrived while its interval was on show, or by the reaction's delay after it.
  EXPECT_EQ(counted(folder,
                    "click WHERE arrived_ns < (SELECT min(flipped_ns) FROM frame WHERE "
                    "frame.attempt_id = click.attempt_id AND frame.interval = "
                    "click.interval)"),
            "0");
}

TEST(AnsweredSession, OfAllKindsAtOnceRunsAndReplays) {
  const TemporaryFolder folder;
  expect_whole_session(folder,
                       run_asked(folder, {kAskRating, kAskYesNo, kAskTwoInterval, kAskFreeText}));
  EXPECT_EQ(counted(folder, "response"), "18");
  EXPECT_EQ(counted(folder, "rating"), "6");
}

TEST(AnsweredSession, WithATimeTooShortForAnybodyIsCompletedAllTheSame) {
  const TemporaryFolder folder;
  std::vector<std::string> hurried;
  for (std::string question : {kAskRating, kAskYesNo, kAskTwoInterval}) {
    hurried.push_back(question.replace(question.find("5000"), 4, "1"));
  }
  expect_whole_session(folder, run_asked(folder, hurried));
  EXPECT_EQ(counted(folder, "rating"), "0");
  EXPECT_EQ(counted(folder,
                    "response WHERE timed_out = 1 AND answer IS NULL AND device = 'none' "
                    "AND arrived_ns - question_shown_ns = 1000000"),
            "18");
}

}  // namespace impetus::answered_session_test
