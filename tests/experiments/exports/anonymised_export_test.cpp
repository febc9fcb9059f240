// An anonymised export holds nothing that tells who took part, and all that was measured.
// SPDX-License-Identifier: MIT
#include <set>

#include "experiments/exports/anonymise.hpp"
#include "tests/experiments/small_study.hpp"
#include "tests/experiments/whole_study.hpp"

namespace impetus::anonymised_export_test {

namespace fs = std::filesystem;

/// What was planted, each where it must not be found again.
const std::vector<std::string> kPersonal{
    "Zebedee-7731",    "Born in Ghent 1961", "I saw a quokka",   "phoned her sister",
    "scribbled aside", "lab-pc-of-hans",     "station-b.sqlite", "1984-06",
    "Quincy-4410",     "key-of-the-page"};

/// The whole study, with a second participant before the first, and personal words everywhere.
fs::path planted(const TemporaryFolder& folder) {
  return WholeStudy::once().copy_to(
      folder,
      "INSERT INTO merged_file VALUES (1, 'station-b.sqlite', 'abc', '1984-06-01T10:00:00Z', 'b', "
      "'1984-06-02T10:00:00Z');"
      "INSERT INTO participant (id, pseudonym, simulated, merged_file_id) VALUES "
      "(50, 'Zebedee-7731', 0, 1);"
      "INSERT INTO enrolment (id, participant_id, protocol_id, seed, planned_utc) VALUES "
      "(60, 50, 1, 1, '1984-06-03T10:00:00Z');"
      "UPDATE participant SET pseudonym = 'Quincy-4410' WHERE pseudonym = 'S01';"
      "UPDATE enrolment SET planned_utc = '1984-06-01T09:00:00.000Z' WHERE id < 60;"
      "UPDATE session SET started_utc = '1984-06-04T09:30:00.000Z', machine = 'lab-pc-of-hans', "
      "page_name = 'Quincy-4410_19840604T093000123Z', page_key = 'key-of-the-page', page_parts = 3;"
      "UPDATE attempt SET saved_utc = '1984-06-04T09:31:00.000Z';"
      "UPDATE study SET created_utc = '1984-06-01T08:00:00Z';"
      "UPDATE answer SET answer = 'Born in Ghent 1961';"
      "UPDATE exclusion SET reason = 'phoned her sister', decided_utc = '1984-06-05T00:00:00Z';"
      "UPDATE note SET text = 'scribbled aside', written_utc = '1984-06-04T09:32:00Z';"
      "INSERT INTO response SELECT id, 9, 'free_text', 'What did you see?', 'I saw a quokka', "
      "NULL, "
      "NULL, '{}', 'key', onset_ns, onset_ns + 5, 1, 0 FROM attempt LIMIT 1;");
}

/// Every byte of a file or of all files of a folder, names included.
std::string bytes_of(const fs::path& place) {
  if (fs::is_regular_file(place)) {
    return text_of(place);
  }
  std::string bytes;
  for (const auto& entry : fs::recursive_directory_iterator(place)) {
    bytes += entry.path().lexically_relative(place).string() + "\n";
    bytes += entry.is_regular_file() ? text_of(entry.path()) : "";
  }
  return bytes;
}

ProgramResult anonymised(const TemporaryFolder& folder, const std::string& format) {
  ProgramResult result = run_program(
      folder, {"export", "a.sqlite", "--format", format, "--out", "out", "--anonymise"});
  EXPECT_EQ(result.status, 0) << result.errors;
  return result;
}

TEST(Anonymise, NothingPersonalIsFoundInAnyByteOfAnyFormat) {
  for (const std::string format : {"csv", "bids", "study"}) {
    const TemporaryFolder folder;
    const std::string before = bytes_of(planted(folder));
    anonymised(folder, format);
    const std::string after = bytes_of(folder / "out");
    for (const std::string& words : kPersonal) {
      EXPECT_NE(before.find(words), std::string::npos) << words << " was not planted";
      EXPECT_EQ(after.find(words), std::string::npos) << words << " in " << format;
    }
    EXPECT_EQ(bytes_of(folder / "a.sqlite"), before) << "the study itself was changed";
  }
}

/// What was measured, without what says whose it is.
std::string measurements_of(const fs::path& file) {
  std::string values;
  for (const char* sql :
       {"SELECT group_concat(x) FROM (SELECT slot || phase || condition || seed AS x FROM trial "
        "ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT hash || hex(digests) || work_granted || "
        "coalesce(fixation_x_m, '') AS x FROM step ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT rating || (arrived_ns - question_shown_ns) AS x FROM "
        "rating ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT body_a || body_b || depth_m || level AS x FROM "
        "collision ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT frame || (flipped_ns - scheduled_ns) || (flipped_ns - "
        "onset_ns) AS x FROM frame JOIN attempt ON attempt.id = attempt_id ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT (taken_ns - onset_ns) || coalesce(x_m, loss) AS x "
        "FROM "
        "gaze JOIN attempt ON attempt.id = attempt_id ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT gap_m || gap_arcmin AS x FROM collision_truth "
        "ORDER BY x)",
        "SELECT group_concat(x) FROM (SELECT kind || accuracy_deg AS x FROM calibration "
        "ORDER BY x)"}) {
    SQLite::Database study(file.string(), SQLite::OPEN_READONLY);
    values += study.execAndGet(sql).getString() + "\n";
  }
  return values;
}

TEST(Anonymise, KeepsEveryMeasurementAndReplaysToTheBit) {
  const TemporaryFolder folder;
  planted(folder);
  anonymised(folder, "study");
  EXPECT_EQ(measurements_of(folder / "out"), measurements_of(folder / "a.sqlite"));
  const ProgramResult replayed = run_program(folder, {"replay", "out"});
  EXPECT_EQ(replayed.status, 0) << replayed.output << replayed.errors;
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos);
  SQLite::Database study((folder / "out").string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(study.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt(), 0);
  EXPECT_EQ(study.execAndGet("PRAGMA integrity_check").getString(), "ok");
  EXPECT_FALSE(study.execAndGet("SELECT anonymised_by FROM study").isNull());
}

TEST(Anonymise, RowsStayWithTheirParticipant) {
  const TemporaryFolder folder;
  planted(folder);
  anonymised(folder, "study");
  const std::string sql =
      "SELECT group_concat(x, ' ') FROM (SELECT protocol.name || ' ' || trial.slot || ' ' || "
      "coalesce(rating.rating, '-') || (SELECT count(*) FROM collision WHERE attempt_id = "
      "attempt.id) || (SELECT count(*) FROM exclusion WHERE exclusion.trial_id = trial.id AND "
      "exclusion.participant_id = enrolment.participant_id) AS x FROM trial JOIN enrolment ON "
      "enrolment.id = enrolment_id JOIN protocol ON protocol.id = protocol_id LEFT JOIN attempt ON "
      "attempt.trial_id = trial.id LEFT JOIN rating ON rating.attempt_id = attempt.id ORDER BY x)";
  EXPECT_EQ(value_of(folder, sql, "out"), value_of(folder, sql, "a.sqlite"));
}

TEST(Anonymise, DatesAreDaysSinceEachParticipantsFirst) {
  const TemporaryFolder folder;
  planted(folder);
  anonymised(folder, "study");
  const auto value = [&](const std::string& sql) { return value_of(folder, sql, "out"); };
  EXPECT_EQ(value("SELECT group_concat(DISTINCT planned_utc) FROM enrolment"),
            "2000-01-01T00:00:00Z");  // of both, though one came two days later
  EXPECT_EQ(value("SELECT group_concat(DISTINCT started_utc) FROM session"),
            "2000-01-04T00:00:00Z");
  EXPECT_EQ(value("SELECT DISTINCT decided_utc FROM exclusion"), "2000-01-05T00:00:00Z");
}

TEST(Anonymise, EachSittingsClockBeginsAnew) {
  const TemporaryFolder folder;
  planted(folder);
  anonymised(folder, "study");
  SQLite::Database study((folder / "out").string(), SQLite::OPEN_READONLY);
  SQLite::Statement query(
      study,
      "SELECT session_id, min(at) FROM (SELECT session_id, onset_ns AS at FROM attempt WHERE "
      "onset_ns > 0 UNION ALL SELECT session_id, flipped_ns FROM frame JOIN attempt ON attempt.id "
      "= attempt_id UNION ALL SELECT session_id, began_ns FROM calibration) GROUP BY session_id");
  int sessions = 0;
  for (; query.executeStep(); ++sessions) {
    EXPECT_EQ(query.getColumn(1).getInt64(), 1'000'000'000);
  }
  EXPECT_EQ(sessions, 3);
}

TEST(Anonymise, CodesAreDrawnAnewSoThatTheirOrderTellsNothing) {
  std::set<std::string> drawn;
  for (int i = 0; i < 24 && drawn.size() < 2; ++i) {  // alike every time: 1 in 2²³
    const TemporaryFolder folder;
    planted(folder);
    anonymised(folder, "study");
    EXPECT_EQ(value_of(folder, "SELECT group_concat(pseudonym) FROM participant", "out"),
              "A01,A02");
    drawn.insert(value_of(folder, "SELECT pseudonym FROM participant WHERE simulated = 1", "out"));
  }
  EXPECT_EQ(drawn.size(), 2U);
}

TEST(Anonymise, TheOwnerOfABorrowedGazeHasTheNewCodeInTheProtocolToo) {
  const TemporaryFolder folder;
  planted(folder);
  change(folder,
         "UPDATE protocol SET protocol_json = json_set(protocol_json, '$.gaze.yoked_to', "
         "json('{\"participant\": \"Zebedee-7731\"}')) WHERE id = 3");
  SQLite::Database study((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
  anonymise(study, "test build", [](const std::string& protocol, const std::string& scene) {
    return "hash of " + std::to_string(protocol.size()) + " " + std::to_string(scene.size());
  });
  EXPECT_EQ(study
                .execAndGet("SELECT json_extract(protocol_json, '$.gaze.yoked_to.participant') = "
                            "(SELECT pseudonym FROM participant WHERE simulated = 0) FROM protocol "
                            "WHERE id = 3")
                .getInt(),
            1);
  EXPECT_EQ(
      study
          .execAndGet("SELECT hash = 'hash of ' || length(CAST(protocol_json AS BLOB)) || ' ' "
                      "|| length(CAST(scene_json AS BLOB)) FROM protocol WHERE id = 3")
          .getInt(),
      1);
}

TEST(Anonymise, WordsThatStandForWhoeverFitsStayAndStrangersHaveANameEach) {
  const TemporaryFolder folder;
  planted(folder);
  change(
      folder,
      "INSERT INTO protocol (name, hash, protocol_json, scene_json) SELECT name, 'h' || value, "
      "json_set(protocol_json, '$.gaze.yoked_to', json_object('participant', value)), scene_json "
      "FROM protocol, json_each('[\"least-followed\", \"previous\", \"Gone-1\", \"Gone-2\"]') "
      "WHERE protocol.id = 3");
  SQLite::Database study((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
  anonymise(study, "test build",
            [](const std::string& protocol, const std::string&) { return "hash of " + protocol; });
  EXPECT_EQ(study
                .execAndGet("SELECT group_concat(json_extract(protocol_json, "
                            "'$.gaze.yoked_to.participant')) FROM (SELECT * FROM protocol WHERE "
                            "hash LIKE 'h%' AND json_extract(protocol_json, '$.gaze.yoked_to') IS "
                            "NOT NULL ORDER BY id)")
                .getString(),
            "least-followed,previous,A00,A00-2");
}

// ---------------------------------------------------------------- the copy

TEST(StudyCopy, IsTheStudyAndIsNotOverwritten) {
  const TemporaryFolder folder;
  planted(folder);
  EXPECT_EQ(run_program(folder, {"export", "a.sqlite", "--format", "study", "--out", "out"}).status,
            0);
  EXPECT_EQ(measurements_of(folder / "out"), measurements_of(folder / "a.sqlite"));
  EXPECT_EQ(
      value_of(folder, "SELECT count(*) FROM participant WHERE pseudonym = 'Zebedee-7731'", "out"),
      "1");
  expect_refused(folder, {"export", "a.sqlite", "--format", "study", "--out", "out"},
                 "out: exists already and is not overwritten without --force");
  expect_refused(folder,
                 {"export", "a.sqlite", "--format", "study", "--out", "a.sqlite", "--force"},
                 "--out: expected another file than the study itself, got a.sqlite");
  folder.write("mine.txt", "mine");
  expect_refused(folder,
                 {"export", "a.sqlite", "--format", "study", "--out", "mine.txt", "--force"},
                 "mine.txt: expected an Impetus study, got a file that is no SQLite database");
  EXPECT_EQ(text_of(folder / "mine.txt"), "mine");
  EXPECT_EQ(
      run_program(folder, {"export", "a.sqlite", "--format", "study", "--out", "out", "--force"})
          .status,
      0);
}

TEST(StudyCopy, NobodysOnlyStudyIsReplacedNorALogTakenForAPartOfIt) {
  const TemporaryFolder folder;
  planted(folder);
  small_study(folder / "theirs.sqlite", {"P55"});
  const std::string theirs = text_of(folder / "theirs.sqlite");
  expect_refused(
      folder, {"export", "a.sqlite", "--format", "study", "--out", "theirs.sqlite", "--force"},
      "theirs.sqlite: expected an earlier export of a.sqlite, got a study of people whom "
      "that has not; it is not overwritten");
  EXPECT_EQ(text_of(folder / "theirs.sqlite"), theirs);
  folder.write("new.sqlite-wal", "of a study that was killed");
  const ProgramResult refused =
      run_program(folder, {"export", "a.sqlite", "--format", "study", "--out", "new.sqlite"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("new.sqlite-wal is there"), std::string::npos) << refused.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "new.sqlite"));
}

}  // namespace impetus::anonymised_export_test
