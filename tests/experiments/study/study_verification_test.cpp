// `impetus verify`: what is whole passes, and whatever was changed, lost or damaged is named.
// SPDX-License-Identifier: MIT
#include "experiments/study/study_verification.hpp"

#include "experiments/store/exclusion.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/small_study.hpp"

namespace impetus::study_verification_test {

using nlohmann::json;

Failures failures_of(const Verification& verification) {
  Failures all;
  for (const VerificationCheck& check : verification.checks) {
    for (const std::string& failure : check.failures) {
      all.push_back(check.name + ": " + failure);
    }
  }
  return all;
}

std::string first_failure(const std::filesystem::path& path) {
  const Failures failures = failures_of(verify_study(path));
  return failures.empty() ? "none" : failures.front();
}

/// What stands against publishing a study of which every check passed.
std::vector<std::string> obstacles_of(const std::filesystem::path& path) {
  const Verification verification = verify_study(path);
  EXPECT_EQ(failures_of(verification), Failures{});
  EXPECT_EQ(verification.publishable(), verification.obstacles.empty());
  return verification.obstacles;
}

bool remarked(const std::filesystem::path& path, const std::string& remark) {
  const std::vector<std::string> remarks = verify_study(path).remarks;
  return std::count(remarks.begin(), remarks.end(), remark) == 1;
}

/// A study that passes, to be copied and changed.
class VerifiedStudy {
 public:
  VerifiedStudy() : whole_(small_study(folder_ / "whole.sqlite", {"P01", "P02"})) {}

  /// A fresh copy.
  [[nodiscard]] std::filesystem::path copy() const {
    const std::filesystem::path path = folder_ / "a.sqlite";
    std::filesystem::copy_file(whole_, path, std::filesystem::copy_options::overwrite_existing);
    return path;
  }

  [[nodiscard]] std::filesystem::path tampered(const std::string& sql) const {
    const std::filesystem::path path = copy();
    tamper(path, sql);
    return path;
  }

  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  std::filesystem::path whole_;
};

std::string last_line(const ProgramResult& result) {
  const std::vector<std::string> lines = lines_of(result.output);
  return lines.empty() ? result.errors : lines.back();
}

TEST(Verify, AWholeStudyCanBePublishedAndIsNotChanged) {
  const VerifiedStudy study;
  const std::filesystem::path path = study.copy();
  const std::string before = text_of(path);
  const ProgramResult result = run_program(study.folder(), {"verify", "a.sqlite", "--replay"});
  EXPECT_EQ(result.status, 0) << result.output << result.errors;
  EXPECT_EQ(last_line(result), "a.sqlite: can be published: 2 participants, 10 trials, 2 sessions");
  EXPECT_EQ(text_of(path), before);
}

TEST(Verify, OfRecordingsOfEarlierVersionsNothingButTheirFramesIsMissing) {
  // tests/recordings/make leaves the frames out, which nothing can be simulated from.
  const std::string no_frames = " frames were counted, 0 are there";
  int recordings = 0;
  for (const auto& file : std::filesystem::directory_iterator(source_file("tests/recordings"))) {
    if (file.path().extension() == ".sqlite") {
      const Verification verification = verify_study(file.path());
      Failures failures = failures_of(verification);
      std::erase_if(failures,
                    [&](const std::string& failure) { return failure.ends_with(no_frames); });
      EXPECT_EQ(failures, Failures{}) << file.path();
      EXPECT_GT(verification.completed_trials, 0) << file.path();
      ++recordings;
    }
  }
  EXPECT_GE(recordings, 12);
}

TEST(Verify, WhateverWasChangedIsNamed) {
  const VerifiedStudy study;
  const std::string hash = small_protocol().hash;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"UPDATE rating SET rating = 9 WHERE attempt_id = 3",
       "values: 1 row of rating breaks CHECK (minimum < maximum AND rating BETWEEN minimum AND "
       "maximum)"},
      {"UPDATE rating SET rating = 9, maximum = 9, best = 1 WHERE attempt_id = 3",
       "answers: P01, causality, slot 3, attempt 1: rated on another scale than the protocol's"},
      {"DELETE FROM rating WHERE attempt_id = 3",
       "answers: P01, causality, slot 3, attempt 1: completed without the rating that was asked "
       "for"},
      {"INSERT INTO click VALUES (3, 1, 'key', 12, 13, 1)",
       "recordings: P01, causality, slot 3, attempt 1: click 1 comes before its cross"},
      {"INSERT INTO click SELECT 3, 1, 'key', onset_ns + 12, 13, 1 FROM attempt WHERE id = 3",
       "answers: P01, causality, slot 3, attempt 1: has clicks, which its protocol does not ask "
       "for"},
      {"DELETE FROM step WHERE attempt_id = 7 AND step = 20",
       "recordings: P02, causality, slot 2, attempt 1: of the steps 0 to 480 there are 480"},
      {"DELETE FROM step WHERE attempt_id = 7 AND step = 480",
       "recordings: P02, causality, slot 2, attempt 1: its last frame shows step 480, the last one "
       "there is 479"},
      {"DELETE FROM step WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: completed without a single step"},
      {"DELETE FROM frame WHERE attempt_id = 7 AND frame = 50",
       "recordings: P02, causality, slot 2, attempt 1: 151 frames were counted, 150 are there"},
      {"UPDATE frame SET missed_slots = 1 WHERE attempt_id = 7 AND frame = 50",
       "recordings: P02, causality, slot 2, attempt 1: 0 frames were counted as late, 1 are"},
      {"UPDATE collision SET step = 5000 WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: a collision of left and right at step 5000, "
       "which is missing"},
      {"UPDATE attempt SET onset_ns = onset_ns + 1 WHERE id = 7",
       "recordings: P02, causality, slot 2, attempt 1: its onset is not the flip of its first "
       "frame "
       "of the stimulus"},
      {"UPDATE attempt SET onset_ns = 0 WHERE id = 7",
       "recordings: P02, causality, slot 2, attempt 1: its onset is not the flip of its first "
       "frame of the stimulus"},
      {"UPDATE frame SET interval = 2 WHERE attempt_id = 7 AND frame = 150",
       "recordings: P02, causality, slot 2, attempt 1: a frame of interval 2, which it has not"},
      {"UPDATE frame SET phase = 'fixation' WHERE attempt_id = 7 AND frame = 100",
       "recordings: P02, causality, slot 2, attempt 1: frame 100 is of the cross, and one before "
       "it of the stimulus"},
      {"UPDATE frame SET shown_time_s = 0 WHERE attempt_id = 7 AND frame = 100",
       "recordings: P02, causality, slot 2, attempt 1: frame 100 shows a time before that of the "
       "frame before it"},
      {"UPDATE step SET shown_frame = 999 WHERE attempt_id = 7 AND step = 20",
       "recordings: P02, causality, slot 2, attempt 1: step 20 is said to be first shown by frame "
       "999, by its time it is by frame "},
      {"UPDATE step SET shown_frame = NULL WHERE attempt_id = 7 AND step = 20",
       "recordings: P02, causality, slot 2, attempt 1: step 20 is said to be first shown by no "
       "frame, by its time it is by frame "},
      {"UPDATE collision SET first_frame = first_frame + 1 WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: the collision of left and right is said to "
       "be first shown by frame "},
      {"UPDATE rating SET device = 'simulated' WHERE attempt_id = 7",
       "provenance: P02, causality, slot 2, attempt 1: answered by simulated, in a session of a "
       "person"},
      {"UPDATE collision SET imposed_hold_ms = 300 WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: held for 0.0 ms, a collision for 300.0"},
      {"UPDATE attempt SET interrupted_by = 'pause' WHERE id = 7",
       "recordings: P02, causality, slot 2, attempt 1: is completed, and was interrupted by pause"},
      {"UPDATE rating SET question_shown_ns = 5 WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: asked before it was shown"},
      {"UPDATE frame SET flipped_ns = (SELECT flipped_ns FROM frame WHERE attempt_id = 7 AND frame "
       "= "
       "149) WHERE attempt_id = 7 AND frame = 150",
       "recordings: P02, causality, slot 2, attempt 1: frame 150 was shown before the frame before "
       "it"},
      {"UPDATE step SET fixation_taken_ns = (SELECT flipped_ns + 12 FROM frame WHERE attempt_id = "
       "7 AND "
       "frame = 150) WHERE attempt_id = 7 AND step BETWEEN 20 AND 30",
       "recordings: P02, causality, slot 2, attempt 1: its steps looked at 1 sample of the gaze "
       "from "
       "within the stimulus that is missing"},
      {"UPDATE rating SET arrived_ns = question_shown_ns - 1 WHERE attempt_id = 7",
       "recordings: P02, causality, slot 2, attempt 1: answered before it was asked"},
      {"UPDATE protocol SET protocol_json = replace(protocol_json, '\"small\"', '\"Small\"')",
       "protocols: protocol causality: its hash is " + hash + ", computed anew it is " +
           small_protocol("Small").hash},
      {"UPDATE protocol SET hash = 'made up'",
       "protocols: protocol causality: its hash is made up, computed anew it is " + hash},
      {"UPDATE protocol SET protocol_json = replace(protocol_json, '\"repetitions\":2', "
       "'\"repetitions\":-2')",
       "protocols: protocol causality:/design/repetitions: expected a whole number ≥ 1 and ≤ 1000, "
       "got -2"},
      {"DELETE FROM trial WHERE id = 4",
       "file: 1 row of attempt refers to a row of trial that is missing"},
      {"DELETE FROM step WHERE attempt_id = 4; DELETE FROM frame WHERE attempt_id = 4; "
       "DELETE FROM rating WHERE attempt_id = 4; DELETE FROM collision WHERE attempt_id = 4; "
       "DELETE FROM attempt WHERE id = 4",
       "order: P01, causality, slot 4: passed over, though slot 5 was completed"},
      {"DELETE FROM step WHERE attempt_id = 5; DELETE FROM frame WHERE attempt_id = 5; "
       "DELETE FROM rating WHERE attempt_id = 5; DELETE FROM collision WHERE attempt_id = 5; "
       "DELETE FROM attempt WHERE id = 5",
       "order: P01, causality: finished, but 1 of its main trials was not completed"},
      {"UPDATE trial SET slot = 50 WHERE id = 4; UPDATE trial SET slot = 4 WHERE id = 5; "
       "UPDATE trial SET slot = 5 WHERE id = 4",
       "plans: P01, causality: slot 4: the plan has a main trial under "},
      {"UPDATE trial SET condition = '{\"delay_ms\":0,\"speed_deg_s\":10,\"viewpoint_deg\":0}'",
       "plans: P01, causality: slot "},
      {"UPDATE trial SET condition = '[1]' WHERE id = 3",
       "plans: P01, causality: slot 3: the plan has a main trial under [1], "},
      {"UPDATE trial SET seed = 1 WHERE id = 3", "plans: P01, causality: slot 3: the plan has a "},
      {"UPDATE participant SET pseudonym = 'P07' WHERE id = 1", "plans: P07, causality: slot "},
      {"UPDATE attempt SET number = 2 WHERE id = 3",
       "order: P01, causality, slot 3: of the attempts 1 to 2 there are 1"},
      {"UPDATE attempt SET id = 100 WHERE id = 30; UPDATE enrolment SET finished_utc = NULL",
       "order: P01, causality, session 1: ended as finished, but the protocol is not"},
      {"UPDATE attempt SET session_id = 2 WHERE id = 3",
       "order: P01, causality, slot 3, attempt 1: belongs to a session of another participant or "
       "protocol"},
      {"UPDATE session SET build = '' WHERE id = 2",
       "provenance: P02, causality, session 2: which build recorded it is missing"},
      {"UPDATE session SET sync_passed = 0",
       "provenance: P01, causality, session 1: trials were recorded though the sync test had "
       "failed "
       "and was not overridden"},
      {"UPDATE session SET recording_format = 99, build = 'Impetus 9.0' WHERE id = 2",
       "provenance: P02, causality, session 2: recording format 99, which this build does not "
       "know; "
       "use the one that recorded it, Impetus 9.0"},
      {"UPDATE participant SET simulated = 1 WHERE id = 1",
       "provenance: P01, causality, session 1: of a person, but P01 is simulated"},
      {"DELETE FROM study",
       "order: the study has lost the row that says when and by which build it was made"},
      {"DROP VIEW rated_trial", "schema: the view rated_trial is missing"},
      {"DROP VIEW rated_trial; CREATE VIEW rated_trial AS SELECT 1 AS rating",
       "schema: the view rated_trial is not as this build makes it"},
      {"PRAGMA writable_schema = ON; "
       "UPDATE sqlite_master SET sql = replace(sql, ''' ''', '''  ''') WHERE name = 'excluded'",
       "schema: the view excluded is not as this build makes it"},
      {"CREATE TRIGGER quiet AFTER INSERT ON rating BEGIN DELETE FROM rating; END",
       "schema: the trigger quiet is none of a study's"},
      {"ALTER TABLE step ADD COLUMN mine TEXT",
       "schema: the table step has, beyond what this build makes, the column mine TEXT"},
      {"ALTER TABLE session RENAME COLUMN machine TO computer",
       "schema: the table session lacks the column machine TEXT NOT NULL"},
      {"DROP INDEX one_completed_attempt", "schema: the index one_completed_attempt is missing"}};
  for (const auto& [sql, sentence] : cases) {
    const std::string found = first_failure(study.tampered(sql));
    EXPECT_EQ(found.substr(0, sentence.size()), sentence) << sql << "\n" << found;
  }
}

TEST(Verify, AChangedStepIsFoundByItsReplay) {
  const VerifiedStudy study;
  static_cast<void>(
      study.tampered("UPDATE step SET hash = hash + 1 "
                     "WHERE attempt_id = 7 AND step = 100"));
  EXPECT_EQ(run_program(study.folder(), {"verify", "a.sqlite"}).status, 0);
  const ProgramResult result = run_program(study.folder(), {"verify", "a.sqlite", "--replay"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(last_line(result),
            "a.sqlite: cannot be published: P02, causality, slot 2, attempt 1: diverges at step "
            "100, in the hash alone");
}

TEST(Verify, AnEmptiedValueIsFoundByItsReplay) {
  const VerifiedStudy study;
  static_cast<void>(study.tampered("UPDATE collision SET distance_m = NULL WHERE attempt_id = 7"));
  const ProgramResult result = run_program(study.folder(), {"verify", "a.sqlite", "--replay"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(last_line(result).find("distance_m is nothing, simulated again "), std::string::npos)
      << last_line(result);
}

TEST(Verify, AnotherFreezeIsFoundByItsReplay) {
  const VerifiedStudy study;
  static_cast<void>(study.tampered("UPDATE attempt SET intended_hold_ms = 7 WHERE id = 7"));
  EXPECT_NE(last_line(run_program(study.folder(), {"verify", "a.sqlite", "--replay"}))
                .find("its intended hold is 7 ms, staged again "),
            std::string::npos);
}

TEST(Verify, AFactorMaySetHowOftenTheEngineSteps) {
  json changed = small_protocol().document.value;
  json& design = changed["design"];
  design["factors"][2] = json::parse(
      R"({"name": "rate", "levels": ["fast"], "sets": {"fast": {"/engine/step_hz": 480}}})");
  design["practice"][0].erase("viewpoint_deg");
  design["practice"][0]["rate"] = "fast";
  const TemporaryFolder folder;
  const Protocol protocol = make_protocol(parse_json("a.json", changed.dump()), causality().scene);
  EXPECT_EQ(first_failure(small_study(folder / "a.sqlite", {"P01"}, protocol)), "none");
}

TEST(Verify, ADamagedFileIsNamedAndLookedAtNoFurther) {
  const VerifiedStudy study;
  const std::string whole = text_of(study.copy());
  study.folder().write("cut.sqlite", whole.substr(0, whole.size() / 2));
  std::string overwritten = whole;
  const std::size_t page = whole.size() / 2 / 4096 * 4096;
  overwritten.replace(page, 4096, std::string(4096, 'x'));
  study.folder().write("page.sqlite", overwritten);
  for (const char* file : {"cut.sqlite", "page.sqlite"}) {
    const ProgramResult result = run_program(study.folder(), {"verify", file});
    EXPECT_EQ(result.status, 1) << file;
    EXPECT_EQ(result.errors, "");
    const std::string start = std::string(file) + ": cannot be published: ";
    EXPECT_EQ(last_line(result).substr(0, start.size()), start);
    EXPECT_EQ(lines_of(result.output).front().rfind("file  WRONG  ", 0), 0U) << result.output;
  }
}

TEST(Verify, WhatIsNoStudyCouldNotBeVerified) {
  const TemporaryFolder folder;
  folder.write("text.sqlite", "a text that is long enough to be looked at");
  expect_refused(folder, {"verify", "none.sqlite"},
                 "none.sqlite: expected an Impetus study, but there is no such file");
  expect_refused(folder, {"verify", "text.sqlite"},
                 "text.sqlite: expected an Impetus study, got a file that is no SQLite database");
}

TEST(Verify, WhoDeclinedIsRemarkedAndHasNoTrial) {
  const TemporaryFolder folder;
  EnrolledStudy at(folder / "a.sqlite");
  {
    StudyWriter writer(at.study, at.enrolment, facts());
    writer.save(QuestionRecord{"consent", "consent", "I agree", "declined"});
    writer.end("declined");
  }
  EXPECT_TRUE(
      remarked(folder / "a.sqlite", "1 of 1 enrolments was declined: no consent, and no trial"));
  StudyWriter(at.study, at.enrolment, facts()).end("quit");  // who comes back takes part
  EXPECT_FALSE(
      remarked(folder / "a.sqlite", "1 of 1 enrolments was declined: no consent, and no trial"));
  const VerifiedStudy study;
  EXPECT_EQ(first_failure(study.tampered("UPDATE session SET ending = 'declined' WHERE id = 2")),
            "order: P02, causality, session 2: ended as declined, but has trials");
}

TEST(Verify, WhatAReaderShouldKnowIsRemarkedAndForbidsNothing) {
  const VerifiedStudy study;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"UPDATE participant SET simulated = 1 WHERE id = 2; UPDATE session SET simulated = 1 "
       "WHERE id = 2; UPDATE rating SET device = 'simulated' WHERE attempt_id > 5",
       "1 of 2 participants is simulated"},
      {"UPDATE session SET ending = NULL, ended_utc = NULL WHERE id = 2",
       "1 of 2 sessions has no ending: killed, or running now"},
      {"UPDATE frame SET missed_slots = 1 WHERE attempt_id = 7 AND frame < 10; UPDATE attempt SET "
       "late_timed_frames = 10 WHERE id = 7; UPDATE attempt SET timed_frames = timed_frames",
       "10 of 1534 timed frames were late (0.65 %)"},
      {"INSERT INTO exclusion VALUES (NULL, 1, NULL, 1, 'asleep', 'then')",
       "left out of the analysis: 1 participant, 0 single trials, with reasons"},
      {"UPDATE session SET build = 'impetus 0.1.0, abc-dirty, GNU' WHERE id = 2",
       "1 session was recorded by a build with changes that no commit holds (-dirty)"},
      {"UPDATE answer SET answer = NULL WHERE kind = 'consent' AND session_id = 2",
       "1 people's enrolments have trials, but no consent that was kept"},
      {"UPDATE answer SET answer = 'mine' WHERE id = (SELECT max(id) FROM answer)",
       "participants' own words are in it: "},
      {"UPDATE study SET anonymised_by = 'a build'; UPDATE participant SET pseudonym = 'A' || id",
       "it was anonymised, by a build"}};
  for (const auto& [sql, remark] : cases) {
    const Verification verification = verify_study(study.tampered(sql));
    EXPECT_EQ(failures_of(verification), Failures{}) << sql;
    EXPECT_TRUE(verification.publishable()) << sql;
    const std::vector<std::string>& remarks = verification.remarks;
    EXPECT_TRUE(std::any_of(
        remarks.begin(), remarks.end(),
        [&, &words = remark](const std::string& each) { return each.rfind(words, 0) == 0; }))
        << remark << "\n"
        << ::testing::PrintToString(remarks);
  }
}

TEST(Verify, AStudyThatIsWholeIsNotPublishedUnfinishedOrBeforeAFailedSyncTest) {
  using Obstacles = std::vector<std::string>;
  const VerifiedStudy study;
  const std::string quit =
      "UPDATE enrolment SET finished_utc = NULL WHERE id = 2; UPDATE session SET ending = 'quit' "
      "WHERE id = 2; ";
  const std::string overridden =
      "UPDATE session SET sync_passed = 0, sync_overridden = 1 WHERE id = 2; UPDATE attempt SET "
      "sync_overridden = 1 WHERE session_id = 2; ";
  const std::string left_out =
      "INSERT INTO exclusion VALUES (NULL, 2, NULL, 1, 'the display', 'then'); ";
  const std::string not_finished = "1 of 2 enrolments is not finished";
  const std::string failed_sync =
      "5 trials were shown by a display that had failed its sync test (marked sync_overridden)";
  EXPECT_EQ(obstacles_of(study.copy()), Obstacles{});
  EXPECT_EQ(obstacles_of(study.tampered(quit)), Obstacles{not_finished});
  EXPECT_EQ(obstacles_of(study.tampered(overridden)), Obstacles{failed_sync});
  EXPECT_EQ(obstacles_of(study.tampered(quit + overridden + left_out)), Obstacles{});
  EXPECT_EQ(obstacles_of(study.tampered(
                overridden + "INSERT INTO exclusion SELECT NULL, 2, trial_id, 1, 'late', 'then' "
                             "FROM attempt WHERE session_id = 2 LIMIT 1")),
            Obstacles{"4" + failed_sync.substr(1)});
  static_cast<void>(study.tampered(quit + overridden));
  const ProgramResult result = run_program(study.folder(), {"verify", "a.sqlite"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(last_line(result),
            "a.sqlite: cannot be published: whole, but " + not_finished + " (and 1 more)");
}

/// A second session of the first enrolment, before a screen of other shape in metres and pixels.
std::string second_session(const std::string& width_m, const std::string& width_px) {
  return "CREATE TEMP TABLE again AS SELECT * FROM session WHERE id = 1; "
         "UPDATE again SET id = 3, screen_width_m = " +
         width_m + ", screen_width_px = " + width_px +
         "; INSERT INTO session SELECT * FROM again; ";
}

TEST(Verify, ScreensThatNobodySpokeOfAreWrongAndThoseSaidStandAgainstPublishing) {
  const VerifiedStudy study;
  const std::string wide = "46.9 cm x 30.1 cm, 1600 x 1024 pixels, seen from 57.0 cm";
  const std::string usual = "37.6 cm x 30.1 cm, 1280 x 1024 pixels, seen from 57.0 cm";
  const std::string changed = second_session("0.469", "1600");
  const std::string eggs = "UPDATE session SET screen_width_px = 1920 WHERE id = 2; ";
  EXPECT_EQ(first_failure(study.tampered(changed)),
            "screens: P01, causality, session 3: sat before " + wide + ", in the session before " +
                usual + ", and nobody said that the screen changed");
  EXPECT_EQ(first_failure(study.tampered(eggs)),
            "screens: P02, causality, session 2: each pixel was 0.196 mm wide and 0.294 mm high "
            "(37.6 cm x 30.1 cm, 1920 x 1024 pixels, seen from 57.0 cm), and nobody said that they "
            "are not square");
  const std::filesystem::path said =
      study.tampered(changed + "INSERT INTO note VALUES (NULL, 3, 'then', 'screen changed', '')");
  EXPECT_EQ(obstacles_of(said),
            std::vector<std::string>{"P01 sat before 2 screens: " + usual + "; " + wide});
  tamper(said, "INSERT INTO exclusion VALUES (NULL, 1, NULL, 1, 'two screens', 'then')");
  EXPECT_EQ(obstacles_of(said), std::vector<std::string>{});
  const std::filesystem::path stretched =
      study.tampered(eggs + "INSERT INTO note VALUES (NULL, 2, 'then', 'pixels not square', '')");
  EXPECT_EQ(obstacles_of(stretched),
            std::vector<std::string>{
                "1 session was before a screen whose pixels, as was said, are not square"});
}

TEST(Verify, ALogBesideAKilledSessionsFileIsReadAndRemarked) {
  const TemporaryFolder folder;
  const std::string path = (folder / "a.sqlite").string();
  ASSERT_EQ(in_child([&] {
              // Ends without closing anything, as a killed process does.
              auto* study = new StudyFile(opened(path));
              add_person(*study, small_protocol(), "P01");
              return std::string("left");
            }),
            "left");
  ASSERT_TRUE(std::filesystem::exists(path + "-wal"));
  EXPECT_EQ(first_failure(path), "none");
  EXPECT_EQ(verify_study(path).completed_trials, 5);
  EXPECT_TRUE(remarked(path,
                       "a part of it stands in a.sqlite-wal until a session or a merge closes the "
                       "file properly; the two belong together"));
}

TEST(Verify, AsJsonItIsTheSame) {
  const VerifiedStudy study;
  static_cast<void>(study.tampered("DELETE FROM rating WHERE attempt_id = 3"));
  const ProgramResult result = run_program(study.folder(), {"verify", "a.sqlite", "--json"});
  EXPECT_EQ(result.status, 1);
  const json found = json::parse(result.output);
  EXPECT_TRUE(found.at("publishable") == json(false));
  int failed = 0;
  for (const json& check : found.at("checks")) {
    failed += check.at("passed").get<bool>() ? 0 : 1;
    EXPECT_EQ(check.at("passed").get<bool>(), check.at("failures").empty());
  }
  EXPECT_EQ(failed, 1);
}

}  // namespace impetus::study_verification_test
