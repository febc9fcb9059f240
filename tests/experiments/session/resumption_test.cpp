// Where a session that was left goes on: at the next trial, at its block's start, or not at all.
// SPDX-License-Identifier: MIT
#include "experiments/session/resumption.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::resumption_test {

Script at_trial() { return {}; }

Script at_block() {
  Script script;
  script.resume.at = ResumeRule::At::kBlock;
  return script;
}

/// One of practice, slot 1, then blocks of three: slots 2 to 4, 5 to 7.
Plan two_blocks_of_three() {
  Plan plan{{1, TrialPhase::kPractice, 1, {}, 1}};
  for (std::int64_t slot = 2; slot <= 7; ++slot) {
    plan.push_back({slot, TrialPhase::kMain, 1, {}, 1, slot <= 4 ? 1 : 2});
  }
  return plan;
}

SessionHistory done_until(std::int64_t slot) {
  SessionHistory history;
  history.resumed = true;
  for (std::int64_t done = 1; done <= slot; ++done) {
    history.completed_slots.insert(done);
    history.attempts[done] = 1;
  }
  return history;
}

using Slots = std::set<std::int64_t>;

TEST(Resumption, AtTheNextTrialNothingIsSetAside) {
  SessionHistory history = done_until(6);
  const Resumption resumption = resume(at_trial(), two_blocks_of_three(), history);
  EXPECT_EQ(resumption.first_slot, 7);
  EXPECT_EQ(resumption.set_aside, Slots{});
  EXPECT_EQ(history.completed_slots, done_until(6).completed_slots);
}

TEST(Resumption, AtTheBlocksStartItsDoneTrialsAreShownAgain) {
  SessionHistory history = done_until(6);
  const Resumption resumption = resume(at_block(), two_blocks_of_three(), history);
  EXPECT_EQ(resumption.first_slot, 5);
  EXPECT_EQ(resumption.set_aside, (Slots{5, 6}));
  EXPECT_EQ(history.completed_slots, (Slots{1, 2, 3, 4}));
  EXPECT_EQ(history.attempts, done_until(6).attempts);  // They are numbered on.
}

TEST(Resumption, BetweenBlocksInPracticeAndAtTheEndNothingIsSetAside) {
  for (const std::int64_t done : {0, 1, 4, 7}) {
    SessionHistory history = done_until(done);
    const Resumption resumption = resume(at_block(), two_blocks_of_three(), history);
    EXPECT_EQ(resumption.set_aside, Slots{});
    EXPECT_EQ(resumption.first_slot, done == 7 ? std::nullopt : std::optional(done + 1));
  }
}

/// Rounds of two practice trials, then a main one: slots 1 to 6, and 7.
Plan three_rounds_of_two() {
  Plan plan;
  for (std::int64_t slot = 1; slot <= 6; ++slot) {
    plan.push_back({slot, TrialPhase::kPractice, (slot + 1) / 2, {}, 1});
  }
  plan.push_back({7, TrialPhase::kMain, 1, {}, 1});
  return plan;
}

/// The first trial of who was right in these practice trials, the first ones.
std::optional<std::int64_t> first_after(const Script& script, const std::vector<bool>& right) {
  SessionHistory history = done_until(static_cast<std::int64_t>(right.size()));
  for (std::size_t i = 0; i < right.size(); ++i) {
    history.practice[static_cast<std::int64_t>(i) + 1].right = right[i];
  }
  return resume(script, three_rounds_of_two(), history).first_slot;
}

TEST(Resumption, PracticeGoesOnWhereItWasLeftUntilItSuffices) {
  Script trains;
  trains.training_rule = TrainingRule{2, 2, 6};
  EXPECT_EQ(first_after(trains, {false}), 2);
  EXPECT_EQ(first_after(trains, {false, false}), 3);  // another round
  EXPECT_EQ(first_after(trains, {false, true, false}), 4);
  EXPECT_EQ(first_after(trains, {false, true, true}), 7);                      // trained
  EXPECT_EQ(first_after(trains, {true, false, true, false, true, false}), 7);  // none is left
  EXPECT_EQ(first_after(Script(), {true}), 2);
  EXPECT_EQ(first_after(Script(), {false, false}), 7);  // nobody asks
}

/// The shipped protocol in blocks of one delay, resumed as said.
std::string blocked_protocol(const TemporaryFolder& folder, const nlohmann::json& rule) {
  nlohmann::json session = nlohmann::json::parse(text_of(causality_file()))["session"];
  session["resume"] = rule;
  const std::string name = changed_protocol(folder, "/session", session);
  nlohmann::json protocol = nlohmann::json::parse(text_of(folder / name));
  protocol["design"]["blocks"] = {{"factors", {"delay_ms"}}, {"order", "random"}};
  protocol["design"].erase("longest_runs");  // of one delay; a block has no other
  folder.write(name, protocol.dump());
  return name;
}

Words run_of(const std::string& protocol) {
  return {"run", protocol, "--db", "a.sqlite", "--observer", "causality", "--participant", "S01"};
}

/// A session that was killed after its 50th trial: 6 of practice, 27 and 17 of two blocks. That was
/// saved at `when`, seen from now ("-2 hours"), the session having begun before.
void leave_after_trial_50(const TemporaryFolder& folder, const std::string& protocol,
                          const std::string& when) {
  EXPECT_EQ(run_program(folder, run_of(protocol)).status, 0);
  change(
      folder,
      "UPDATE enrolment SET finished_utc = NULL;"
      "CREATE TEMP TABLE late AS SELECT attempt.id FROM attempt JOIN trial ON trial.id = trial_id "
      "WHERE slot > 50;"
      "DELETE FROM rating WHERE attempt_id IN late; DELETE FROM step WHERE attempt_id IN late;"
      "DELETE FROM frame WHERE attempt_id IN late; DELETE FROM note;"
      "DELETE FROM collision WHERE attempt_id IN late; DELETE FROM attempt WHERE id IN late;"
      "UPDATE attempt SET saved_utc = strftime('%Y-%m-%dT%H:%M:%fZ', 'now', '" +
          when +
          "');"
          "UPDATE session SET ended_utc = NULL, ending = NULL, "
          "started_utc = strftime('%Y-%m-%dT%H:%M:%fZ', 'now', '-9 hours')");
}

TEST(Resume, AtABlocksStartKeepsWhatWasDoneSetAsideAndEndsWithTheWholePlan) {
  const TemporaryFolder folder;
  const std::string protocol = blocked_protocol(folder, {{"at", "block"}});
  leave_after_trial_50(folder, protocol, "-2 hours");
  EXPECT_EQ(complaints_of(run_program(folder, run_of(protocol))), "");
  EXPECT_EQ(value_of(folder,
                     "SELECT count(*) || ' from ' || min(slot) || ' to ' || max(slot) "
                     "FROM attempt JOIN trial ON trial.id = trial_id "
                     "WHERE outcome = 'set aside' AND set_aside_in = 2"),
            "17 from 34 to 50");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM attempt WHERE outcome = 'completed'"), "87");
  EXPECT_EQ(value_of(folder,
                     "SELECT resumed_at || first_slot || round(resumed_after_s / 3600, 1) "
                     "FROM session WHERE id = 2"),
            "block342.0");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial"), "87");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rating"), "104");  // Nothing was thrown away.
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_NE(replayed.output.find("104 trials"), std::string::npos) << replayed.output;
  EXPECT_EQ(replayed.status, 0);
}

TEST(Resume, AfterTheLongestTimeIsRefusedAndNothingChanges) {
  const TemporaryFolder folder;
  const std::string protocol = blocked_protocol(folder, {{"at", "trial"}, {"refuse_after_h", 1.5}});
  leave_after_trial_50(folder, protocol, "-2 hours");
  expect_refused(folder, run_of(protocol),
                 "a.sqlite: participant S01 left causality 2 h ago; it is resumed within 1.5 h "
                 "(/session/resume/refuse_after_h), then no more");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM session"), "1");
}

TEST(Resume, AClockThatWasSetBackIsSaidAndLosesNothing) {
  const TemporaryFolder folder;
  const std::string protocol = blocked_protocol(folder, {{"at", "trial"}});
  leave_after_trial_50(folder, protocol, "+3 hours");
  const ProgramResult result = run_program(folder, run_of(protocol));
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.errors,
            "warning: the last record of S01 lies 3 h ahead of this machine's clock, which may "
            "have been set back; the gap is stored as it is\n");
  EXPECT_EQ(value_of(folder, "SELECT resumed_after_s < -10000 FROM session WHERE id = 2"), "1");
  EXPECT_EQ(value_of(folder, "SELECT count(*) FROM rated_trial"), "87");
}

TEST(Resume, ThatCannotBeIsRefusedWithTheProtocol) {
  const TemporaryFolder folder;
  nlohmann::json session = nlohmann::json::parse(text_of(causality_file()))["session"];
  session["resume"] = {{"at", "block"}};
  expect_refused_without_a_file(
      folder, run_of(changed_protocol(folder, "/session", session)),
      "protocols/a.json:/session/resume/at: expected \"trial\" where /design has no blocks, got "
      "\"block\"");
}

}  // namespace impetus::resumption_test
