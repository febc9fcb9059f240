// `impetus sessions`: who took part, how far they came, how each sitting went.
// SPDX-License-Identifier: MIT
#include "experiments/store/session_list.hpp"

#include "experiments/store/exclusion.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/small_study.hpp"

namespace impetus::session_list_test {

using nlohmann::json;

SessionList listed(const std::filesystem::path& path, bool in_use = false) {
  StudyFile study = StudyFile::open_for_reading(path);
  return load_session_list(study, in_use);
}

/// Quits when the third trial is to be rated.
std::function<Answer(const Page&)> quits_at_third_rating() {
  return [ratings = 0](const Page& page) mutable {
    Answer answer;
    if (page.layout == Page::Layout::kScale && ++ratings == 3) {
      answer.interruption = Interruption::kDisplayClosed;
    }
    return answer;
  };
}

TEST(SessionList, TellsHowFarEachParticipantCame) {
  const TemporaryFolder folder;
  const SessionList list = listed(small_study(folder / "a.sqlite", {"P01", "P02"}));
  ASSERT_EQ(list.participations.size(), 2U);
  const Participation& second = list.participations[1];
  EXPECT_EQ(second.participant, "P02");
  EXPECT_FALSE(second.simulated);
  EXPECT_EQ(second.protocol, "causality");
  EXPECT_EQ(second.planned_trials, 4);
  EXPECT_EQ(second.completed_trials, 4);
  EXPECT_EQ(second.practice_trials, 1);
  EXPECT_NE(second.finished_utc, "");
  EXPECT_GT(second.timed_frames, 0);
  EXPECT_EQ(second.late_timed_frames, 0);
  ASSERT_EQ(second.sittings.size(), 1U);
  EXPECT_EQ(second.sittings[0].ending, "finished");
  EXPECT_FALSE(second.sittings[0].resumed);
  EXPECT_TRUE(second.sittings[0].sync_passed);
  EXPECT_EQ(second.sittings[0].completed_trials, 5);
}

TEST(SessionList, ASessionThatWasLeftAndOneThatWentOnAreTold) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.sqlite";
  {
    StudyFile study = opened(path);
    const Protocol protocol = small_protocol();
    const Plan plan = plan_for(protocol, "P01", 1);
    Enrolment enrolment = enrol(study, "P01", false, texts_of(protocol), 1, stored(plan));
    run_sitting(study, enrolment, protocol, plan, facts(), quits_at_third_rating());
    Enrolment again = *find_enrolment(study, "P01", false, texts_of(protocol));
    SessionFacts resumed = facts();
    resumed.resumed = ResumedSession{ResumeRule::At::kTrial, 90.0, {}};
    resumed.sync.passed = false;
    resumed.sync_overridden = true;
    resumed.gaze_source = "mouse";
    run_sitting(study, again, protocol, plan, resumed);
  }
  const SessionList list = listed(path);
  ASSERT_EQ(list.participations.at(0).sittings.size(), 2U);
  EXPECT_EQ(list.participations[0].interrupted_attempts, 1);
  const ListedSession& first = list.participations[0].sittings[0];
  EXPECT_EQ(first.ending, "quit");
  EXPECT_EQ(first.completed_trials, 2);
  const ListedSession& second = list.participations[0].sittings[1];
  EXPECT_TRUE(second.resumed);
  EXPECT_EQ(second.resumed_at, "trial");
  EXPECT_EQ(second.resumed_after_s, 90.0);
  EXPECT_EQ(second.completed_trials, 3);
  EXPECT_TRUE(second.sync_overridden);
  EXPECT_EQ(second.gaze_source, "mouse");
}

TEST(SessionList, WhatIsExcludedAndWhatIsNotedStandsInIt) {
  const TemporaryFolder folder;
  const std::filesystem::path path = small_study(folder / "a.sqlite");
  {
    StudyFile study = opened(path);
    exclude(study, {"P01", 3, true, "the phone rang"});
  }
  tamper(path,
         "INSERT INTO note (session_id, written_utc, kind, text) VALUES "
         "(1, '2026-01-01T00:00:00Z', 'gaze lost', 'trial 2'), "
         "(1, '2026-01-01T00:00:01Z', 'gaze lost', 'trial 4'), "
         "(1, '2026-01-01T00:00:02Z', 'break', 'after main trial 2')");
  const SessionList list = listed(path);
  ASSERT_EQ(list.left_out.size(), 1U);
  EXPECT_EQ(list.left_out[0].trial, 3);
  EXPECT_EQ(list.left_out[0].reason, "the phone rang");
  const std::vector<NoteSummary>& notes = list.participations.at(0).sittings.at(0).notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].kind, "gaze lost");
  EXPECT_EQ(notes[0].count, 2);
  EXPECT_EQ(notes[0].first_text, "trial 2");
}

TEST(Sessions, AKilledSessionHasNoEndingAndLastsToWhatItSavedLast) {
  const TemporaryFolder folder;
  tamper(small_study(folder / "a.sqlite"),
         "UPDATE session SET ending = NULL, ended_utc = NULL, started_utc = "
         "'2026-01-01T10:00:00.000Z'; UPDATE attempt SET saved_utc = '2026-01-01T10:23:10.000Z'; "
         "UPDATE enrolment SET finished_utc = NULL");
  const ProgramResult result = run_program(folder, {"sessions", "a.sqlite"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("2026-01-01 10:00:00  23 min  none: killed  -        5       "),
            std::string::npos)
      << result.output;
}

TEST(Sessions, ARunningSessionIsListedAsSuch) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  StudyWriter writer(at.study, at.enrolment, facts());
  writer.save(recorded_attempts()[0]);
  writer.await_saved();
  const ProgramResult result = run_program(folder, {"sessions", "a.sqlite"});
  EXPECT_EQ(result.errors, "");
  EXPECT_NE(result.output.find("none yet: in use now"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("P01          person  causality  0/4"), std::string::npos)
      << result.output;
}

TEST(Sessions, AnEmptyStudyIsOneSentence) {
  const TemporaryFolder folder;
  { opened(folder / "a.sqlite"); }
  tamper(folder / "a.sqlite", "UPDATE study SET created_utc = '2026-01-01T10:00:00.000Z'");
  const ProgramResult result = run_program(folder, {"sessions", "a.sqlite"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output,
            "a.sqlite: nobody takes part yet; the study was made at 2026-01-01 10:00:00 UTC\n");
}

TEST(Sessions, WhatAnybodyWroteStaysInItsCell) {
  const TemporaryFolder folder;
  { EnrolledStudy at(folder / "a.sqlite", "P\x1b[31m\n1"); }
  const ProgramResult result = run_program(folder, {"sessions", "a.sqlite"});
  EXPECT_EQ(result.output.find('\x1b'), std::string::npos);
  EXPECT_NE(result.output.find("P\\x1b[31m\\x0a1  person  causality"), std::string::npos)
      << result.output;
}

TEST(Sessions, AsJsonTheyAreTheSame) {
  const TemporaryFolder folder;
  small_study(folder / "a.sqlite", {"P01", "P02"});
  const ProgramResult result = run_program(folder, {"sessions", "a.sqlite", "--json"});
  const json list = json::parse(result.output);
  ASSERT_EQ(list.at("participations").size(), 2U);
  const json& second = list.at("participations").at(1);
  EXPECT_TRUE(second.at("participant") == json("P02"));
  EXPECT_TRUE(second.at("completed_trials") == json(4));
  EXPECT_TRUE(second.at("sittings").at(0).at("ending") == json("finished"));
  EXPECT_TRUE(second.at("sittings").at(0).at("resumed_after_s").is_null());
  EXPECT_TRUE(list.at("left_out").empty());
}

TEST(Sessions, OfACopyThatCannotBeWrittenAreListed) {
  const OpenFolder folder;
  const std::filesystem::path path = small_study(folder / "a.sqlite");
  // As a session that was killed leaves the file: in write-ahead mode. Its log is not copied.
  tamper(path, "PRAGMA journal_mode = WAL");
  ASSERT_EQ(text_of(path).substr(18, 2), "\x02\x02");
  std::filesystem::permissions(path, std::filesystem::perms(0444));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
  EXPECT_EQ(in_child([&] {
              become_nobody();
              return listed(path).participations.at(0).participant;
            }),
            "P01");
}

}  // namespace impetus::session_list_test
