// Records as lines of JSON: every field comes back, and what is no record is refused in words.
// SPDX-License-Identifier: MIT
#include "experiments/lines/record_lines.hpp"

#include <gtest/gtest.h>

#include "engine/numerics/random_stream.hpp"
#include "experiments/lines/replayed_attempt.hpp"
#include "tests/experiments/golden_study.hpp"

namespace impetus::record_lines_test {

using nlohmann::json;

/// A record with no field as it is by default, as far as one of each kind goes.
AttemptRecord full_attempt() {
  AttemptRecord attempt;
  attempt.slot = 3;
  attempt.number = 2;
  attempt.outcome = AttemptOutcome::kCompleted;
  attempt.onset_ns = 9'007'199'254'740'993;  // no double
  attempt.body_names = {"left", "“right”"};
  StepRecord step;
  step.step = 7;
  step.state = {0xfedcba9876543210U, {{1, 2, 3, 4}, {5, 6, 7, 8}}};
  step.gaze = {ScreenPoint{0.1, -0.2}, 5, 6, GazeRegion{{0.3, 0.4}, 5.5}};
  step.not_finite = {{1, StateField::kOrientation}};
  step.cut_work.of(WorkPhase::kRefinement) = 12;
  attempt.steps = {step, StepRecord{}};
  CollisionRecord collision;
  collision.report.bodies = {0, wall_index(2)};
  collision.report.stop = StopReason::kCapped;
  collision.report.contact.touch.point = Vector3(0.1, 1e-300, -1.0 / 3.0);
  collision.priority = 0.25;
  collision.imposed_spin = ImposedSpin{Vector3(1, 2, 3), Vector3(4, 5, 6)};
  attempt.collisions = {collision};
  attempt.frames = {{4, FramePhase::kFixation, 0.5, {1, 2, 3, 1}, 2, 9}};
  attempt.ratings = {{3, 1, 5, 5, "low", "high", "key", 10, 11, 12}};
  attempt.clicks = {{"mouse", 1, 2, 1}};
  attempt.gaze_source = "mouse";
  attempt.gaze = {{1, ScreenPoint{0.1, 0.2}, GazeLoss::kNone, 1}, {2, {}, GazeLoss::kBlink, 2}};
  attempt.gaze_lost_share = 0.125;
  attempt.responses = {{"yes_no",
                        "Seen?",
                        "yes",
                        true,
                        std::nullopt,
                        {{"x", 1.5}, {"y", std::string("z")}, {"w", true}},
                        "key",
                        1,
                        2,
                        3,
                        true}};
  attempt.interrupted_by = "pause";
  return attempt;
}

std::string sentence_of(const json& line) {
  try {
    record_from(line);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RecordLines, WhatWasWrittenIsReadAndWrittenAlike) {
  const std::string line = line_of(full_attempt(), Digests::kKept);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const AnyRecord back = record_from(json::parse(line));
  EXPECT_EQ(line_of(back, Digests::kKept), line);
  const auto& attempt = std::get<AttemptRecord>(back);
  EXPECT_EQ(attempt.onset_ns, 9'007'199'254'740'993);
  EXPECT_EQ(attempt.steps[0].state.hash, 0xfedcba9876543210U);
  EXPECT_EQ(attempt.steps[0].state.bodies[1][3], 8);
  EXPECT_EQ(attempt.steps[0].cut_work.of(WorkPhase::kRefinement), 12);
  EXPECT_EQ(attempt.steps[1].gaze.fixation, std::nullopt);
  EXPECT_EQ(attempt.collisions[0].report.contact.touch.point.z(), -1.0 / 3.0);
  EXPECT_EQ(attempt.gaze[1].loss, GazeLoss::kBlink);
  EXPECT_EQ(attempt.responses[0].detail[2].value, LevelValue(true));
}

TEST(RecordLines, DigestsCanBeLeftOut) {
  const std::string line = line_of(full_attempt());
  const auto attempt = std::get<AttemptRecord>(record_from(json::parse(line)));
  EXPECT_TRUE(attempt.steps[0].state.bodies.empty());
  EXPECT_EQ(attempt.steps[0].state.hash, 0xfedcba9876543210U);
}

TEST(RecordLines, EveryKindComesBack) {
  SessionRecord session;
  session.participant = "P01";
  session.seed = 0xffffffffffffffffU;
  session.sync.verdict = "as good as it gets";
  PlannedTrial trial{1, TrialPhase::kPractice, 2, {{"delay_ms", 100.0}}, 5};
  trial.solved = {{"/a", 0.1}};
  CalibrationRecord calibration;
  calibration.points = {{{0.1, 0.2}, ScreenPoint{0.3, 0.4}, 1.0, {}, {}, 5, 1}};
  calibration.correction = GazeCorrection{};
  for (const AnyRecord& record : std::initializer_list<AnyRecord>{
           session, trial, QuestionRecord{"demographic", "age", "Your age", "33"},
           NoteRecord{"pause", ""}, ChosenLevel{4, {{"delay_ms", 50.0}}, {{"reversals", 2.0}}},
           calibration, FinishedRecord{}}) {
    const std::string line = line_of(record);
    EXPECT_EQ(line_of(record_from(json::parse(line))), line);
  }
}

TEST(RecordLines, WhatIsNoRecordIsRefusedInWords) {
  EXPECT_EQ(sentence_of(5),
            "expected a line whose kind is one of [\"session\",\"trial\",\"attempt\",\"answer\","
            "\"note\",\"level\",\"calibration\",\"finished\"], got 5");
  json line = json::parse(line_of(full_attempt()));
  line["outcome"] = "won";
  EXPECT_EQ(sentence_of(line),
            "outcome: expected one of [\"completed\",\"interrupted\"], got \"won\"");
  line = json::parse(line_of(full_attempt()));
  line["clicks"][0] = {"device"};
  EXPECT_EQ(sentence_of(line),
            "clicks: expected the columns [\"device\",\"arrived_ns\",\"arrival_uncertainty_ns\","
            "\"interval\"], got [\"device\"]");
  constexpr std::size_t kDeep = 300'000;
  EXPECT_TRUE(sentence_of(json::parse(std::string(kDeep, '[') + std::string(kDeep, ']')))
                  .ends_with("got an array"));
  line["clicks"] = 3;
  EXPECT_EQ(sentence_of(line), "clicks: expected a list, got 3");
}

TEST(RecordLines, NumbersThatNoIntegerHoldsAreRefused) {
  const std::string holds = " -9223372036854775808 to 9223372036854775807, got ";
  for (const char* number : {"1647163408917979831362", "9223372036854775808", "1e30", "2.5"}) {
    json line = json::parse(line_of(full_attempt()));
    line["slot"] = json::parse(number);
    EXPECT_EQ(sentence_of(line), "slot: expected an integer from" + holds + line["slot"].dump());
  }
}

TEST(RecordLines, AnyChangeOfALetterIsReadOrRefused) {
  const std::string line = line_of(full_attempt(), Digests::kKept);
  RandomStream letters(20'26, "letters of lines");
  for (int change = 0; change < 5000; ++change) {
    std::string changed = line;
    changed[letters.place_below(changed.size())] = static_cast<char>(letters.below(127));
    const json parsed = json::parse(changed, nullptr, /*allow_exceptions=*/false);
    if (!parsed.is_discarded()) {
      EXPECT_NE(sentence_of(parsed), "");
    }
  }
}

TEST(RecordLines, GoldenAttemptsReplayAndAreGivenTheirDigestsBack) {
  Golden golden;
  for (std::size_t at = 0; at < 3; ++at) {
    const StoredAttempt& stored = golden.attempts[at];
    const GoldenProtocol& source = golden.protocol_of(stored);
    SessionRecord session;
    session.screen = stored.screen;
    PlannedTrial trial{
        stored.trial.slot, stored.trial.phase, stored.trial.repetition,
        condition_from_json(json::parse(stored.trial.condition), source.protocol.design),
        stored.trial.seed};
    AttemptRecord recorded;
    recorded.steps = golden.steps(stored);
    auto handed = std::get<AttemptRecord>(record_from(json::parse(line_of(recorded))));
    const ReplayedAttempt found =
        AttemptReplay(source.protocol, session, stored.recording_format).replay(trial, handed);
    EXPECT_EQ(found.steps, static_cast<std::int64_t>(recorded.steps.size()) - 1);
    EXPECT_FALSE(found.divergence);
    for (std::size_t step = 0; step < recorded.steps.size(); ++step) {
      EXPECT_EQ(handed.steps[step].state.bodies, recorded.steps[step].state.bodies);
    }
    recorded.steps[5].state.hash ^= 1U;
    recorded.steps[5].state.bodies[1][0] ^= 1U;
    const ReplayedAttempt turned =
        AttemptReplay(source.protocol, session, stored.recording_format).replay(trial, recorded);
    ASSERT_TRUE(turned.divergence);
    EXPECT_EQ(divergence_words(stored.trial_id, *turned.divergence),
              "trial " + std::to_string(stored.trial_id) + ", step 5, body right, position");
  }
}

}  // namespace impetus::record_lines_test
