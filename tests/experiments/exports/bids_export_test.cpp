// An export as BIDS keeps the rules of version 1.11 that concern it, and says what was measured.
// SPDX-License-Identifier: MIT
#include "experiments/exports/bids_session.hpp"
#include "experiments/exports/gzip.hpp"
#include "experiments/tables/csv_line.hpp"
#include "tests/experiments/bids_rules.hpp"

namespace impetus::bids_export_test {

/// The whole study's export, made once.
const TemporaryFolder& exported() {
  static const TemporaryFolder kFolder;
  static const ProgramResult kResult = run_program(
      kFolder, {"export", WholeStudy::once().file(), "--format", "bids", "--out", "out"});
  EXPECT_EQ(kResult.status, 0) << kResult.errors;
  return kFolder;
}

TEST(BidsExport, KeepsTheRulesOfBids) {
  Dataset dataset(exported() / "out");
  EXPECT_EQ(dataset.breaches(), std::vector<std::string>());
  EXPECT_EQ(dataset.files().count("sub-S01/ses-01/beh/sub-S01_ses-01_task-causality_events.tsv"),
            1U);
  EXPECT_EQ(
      dataset.files().count(
          "sub-S01/ses-03/beh/sub-S01_ses-03_task-gazecontingent_recording-eye1_physio.tsv.gz"),
      1U);
}

TEST(BidsExport, BreachesAreFound) {
  const TemporaryFolder folder;
  const auto breaches_with = [&](const std::string& file, const std::string& text) {
    fs::remove_all(folder / "out");
    fs::copy(exported() / "out", folder / "out", fs::copy_options::recursive);
    folder.write("out/" + file, text);
    return Dataset(folder / "out").breaches().size();
  };
  const std::string stem = "sub-S01/ses-01/beh/sub-S01_ses-01_task-causality_events";
  const std::string events = text_of(exported() / ("out/" + stem + ".tsv"));
  EXPECT_GT(breaches_with(stem + ".tsv", replaced(events, "onset\tduration", "duration\tonset")),
            0U);
  EXPECT_GT(breaches_with(stem + ".tsv", replaced(events, "n/a", "")), 0U);
  EXPECT_GT(breaches_with(stem + ".json", "{}"), 0U);
  EXPECT_GT(breaches_with("sub-S02/ses-01/beh/sub-S02_ses-01_task-a_beh.tsv", "a\n"), 0U);
  EXPECT_GT(breaches_with("notes.txt", ""), 0U);
}

/// The export once more, over the folder "out".
ProgramResult export_again(const TemporaryFolder& folder) {
  return run_program(
      folder, {"export", WholeStudy::once().file(), "--format", "bids", "--out", "out", "--force"});
}

TEST(BidsExport, IsReplacedWithForceUnlessItHoldsSomethingElse) {
  const TemporaryFolder folder;
  fs::copy(exported() / "out", folder / "out", fs::copy_options::recursive);
  const std::string mine = "sub-S01/ses-01/beh/sub-S01_ses-01_task-questionnaire_beh.tsv";
  folder.write("out/" + mine, "mine");
  EXPECT_EQ(export_again(folder).errors,
            "impetus: " + (folder / "out").string() +
                ": expected an earlier export to overwrite, got one that also holds " + mine +
                ", which no export wrote\n");
  EXPECT_EQ(text_of(folder / ("out/" + mine)), "mine");
  fs::remove(folder / ("out/" + mine));
  EXPECT_EQ(export_again(folder).status, 0);
}

TEST(BidsExport, OfABuildThatListedNoFilesIsReplacedUnlessItHoldsSomethingElse) {
  const TemporaryFolder folder;
  fs::copy(exported() / "out", folder / "out", fs::copy_options::recursive);
  json description = json::parse(text_of(folder / "out/dataset_description.json"));
  ASSERT_EQ(description["GeneratedBy"][0].erase("Files"), 1U);
  folder.write("out/dataset_description.json", description.dump());
  folder.write("out/sub-S01/ses-01/anat/sub-S01_ses-01_T1w.json", "{}");
  EXPECT_EQ(export_again(folder).status, 2);
  fs::remove_all(folder / "out/sub-S01/ses-01/anat");
  EXPECT_EQ(export_again(folder).status, 0);
  description["GeneratedBy"][0]["Name"] = "fMRIPrep";
  folder.write("out/dataset_description.json", description.dump());
  EXPECT_EQ(export_again(folder).status, 2);
}

TEST(BidsExport, HasAnEventForEveryStimulusAnswerClickAndCollision) {
  const Dataset dataset(exported() / "out");
  SQLite::Database study(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  std::map<std::string, int> events;
  int tests = 0;
  for (const std::string& file : dataset.files()) {
    if (file.ends_with("_events.tsv")) {
      const Table table = dataset.table(file);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        ++events[table.at(row, "trial_type")];
        tests += table.at(row, "trial_type") == "stimulus" &&
                 table.at(row, "interval") == table.at(row, "test_interval");
      }
    }
  }
  const auto count = [&](const std::string& sql) {
    return study.execAndGet("SELECT count(*) FROM " + sql).getInt();
  };
  EXPECT_EQ(events["rating"], count("rating"));
  EXPECT_EQ(events["two_interval"], count("response WHERE kind = 'two_interval'"));
  EXPECT_EQ(tests, count("response WHERE kind = 'two_interval'"));
  EXPECT_EQ(events["click"], count("click"));
  EXPECT_EQ(events["collision"], count("collision"));
  EXPECT_EQ(events["stimulus"], count("attempt") + count("response WHERE kind = 'two_interval'"));
  EXPECT_GT(events["click"], 0);
  EXPECT_GT(events["calibration"], 0);
}

TEST(BidsExport, AnEventHasTheTimesOfTheStudyInSeconds) {
  const Dataset dataset(exported() / "out");
  const Table table = dataset.table(dataset.file("task-causality_events.tsv"));
  SQLite::Database study(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  const double first_s = study
                             .execAndGet(
                                 "SELECT min(flipped_ns) / 1e9 FROM frame JOIN attempt ON "
                                 "attempt.id = attempt_id WHERE session_id = 1")
                             .getDouble();
  std::size_t rating = 0;
  while (table.at(rating, "trial_type") != "rating") {
    ++rating;
  }
  const double shown_s =
      study.execAndGet("SELECT min(question_shown_ns) / 1e9 FROM rating").getDouble();
  const double took_s = study
                            .execAndGet(
                                "SELECT (arrived_ns - question_shown_ns) / 1e9 FROM rating "
                                "ORDER BY question_shown_ns LIMIT 1")
                            .getDouble();
  constexpr double kNanoseconds = 2e-9;  // what a double of thousands of seconds keeps, and more
  EXPECT_NEAR(std::stod(table.at(rating, "onset")), shown_s - first_s, 1e3 * kNanoseconds);
  EXPECT_NEAR(std::stod(table.at(rating, "response_time")), took_s, kNanoseconds);
}

TEST(BidsExport, GazeIsInPixelsFromTheTopLeftAndItsSourceIsSaid) {
  const Dataset dataset(exported() / "out");
  const std::string file = dataset.file("_physio.tsv.gz");
  SQLite::Database study(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  SQLite::Statement sample(
      study,
      "SELECT x_m, y_m, screen_width_m, screen_width_px, screen_height_m, screen_height_px "
      "FROM gaze JOIN attempt ON attempt.id = attempt_id JOIN session ON session.id = session_id "
      "WHERE onset_ns > 0 ORDER BY taken_ns LIMIT 1");
  ASSERT_TRUE(sample.executeStep());
  const auto value = [&](int column) { return sample.getColumn(column).getDouble(); };
  const auto rows = dataset.gaze(file);
  // pixel = (½ + metres / size) · resolution, downwards for y
  EXPECT_NEAR(std::stod(rows[0][1]), (0.5 + value(0) / value(2)) * value(3), 1e-6);
  EXPECT_NEAR(std::stod(rows[0][2]), (0.5 - value(1) / value(4)) * value(5), 1e-6);
  EXPECT_EQ(static_cast<int>(rows.size()), study.execAndGet("SELECT count(*) FROM gaze").getInt());
  const json words = dataset.sidecar(file);
  EXPECT_EQ(words["GazeSource"].get<std::string>(), "simulated eye");
  EXPECT_GT(words["CalibrationCount"].get<int>(), 0);
}

TEST(BidsExport, AMouseIsSaidToBeNoEye) {
  const TemporaryFolder folder;
  WholeStudy::once().copy_to(folder,
                             "UPDATE attempt SET gaze_source = 'mouse' WHERE gaze_source IS "
                             "NOT NULL; UPDATE session SET gaze_source = NULL");
  ASSERT_EQ(run_program(folder, {"export", "a.sqlite", "--format", "bids", "--out", "out"}).status,
            0);
  const Dataset dataset(folder / "out");
  const json words = dataset.sidecar(dataset.file("_physio.tsv.gz"));
  EXPECT_NE(words["Description"].get<std::string>().find("stands in for the gaze: no eye"),
            std::string::npos);
}

TEST(BidsExport, HostileCodesBecomeLabelsOfTheirOwnAndStayTextInTheTable) {
  const TemporaryFolder folder;
  WholeStudy::once().copy_to(
      folder,
      "UPDATE participant SET pseudonym = '../a' || char(9, 10) || 'b<script>'; "
      "INSERT INTO participant (pseudonym, simulated) VALUES ('a b s cript', 1), ('//', 1)");
  ASSERT_EQ(run_program(folder, {"export", "a.sqlite", "--format", "bids", "--out", "out"}).status,
            0);
  Dataset dataset(folder / "out");
  EXPECT_EQ(dataset.breaches(), std::vector<std::string>());
  const Table people = dataset.table("participants.tsv");
  ASSERT_EQ(people.rows.size(), 3U);
  EXPECT_EQ(people.at(0, "participant_id"), "sub-abscript");
  EXPECT_EQ(people.at(0, "code"), "../a  b<script>");
  EXPECT_EQ(people.at(1, "participant_id"), "sub-abscriptX2");
  EXPECT_EQ(people.at(2, "participant_id"), "sub-X2");
}

TEST(BidsLabels, NoTwoNamesShareOneCapitalsApart) {
  BidsLabels labels;
  std::set<std::string> given;
  for (const std::string name : {"P01", "p01", "P-01", "P01X2", "", "é", "X2", "🙂"}) {
    std::string label = labels.label_for(name);
    EXPECT_EQ(label.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                      "0123456789"),
              std::string::npos);
    std::transform(label.begin(), label.end(), label.begin(), [](char letter) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    });
    EXPECT_TRUE(given.insert(label).second) << name << " " << label;
  }
}

TEST(TsvLine, WhatIsMissingIsSaidAndNothingBreaksTheLine) {
  EXPECT_EQ(tsv_line({"a", "", "b"}), "a\tn/a\tb\n");
  EXPECT_EQ(tsv_text("two\nlines\tand a tab"), "two lines and a tab");
}

TEST(Gzip, TheSameBytesGiveTheSameFileAndComeBack) {
  const TemporaryFolder folder;
  std::string bytes;
  for (std::int64_t i = 0; i < 300'000; ++i) {
    bytes += static_cast<char>((i * i) % 251);
  }
  for (const std::string& each : {std::string(), std::string("a"), bytes}) {
    EXPECT_EQ(gzip(each), gzip(each));
    EXPECT_EQ(unzipped(folder.write("a.gz", gzip(each))), each);
    EXPECT_EQ(gzip(each).substr(4, 4), std::string(4, '\0')) << "a time in the header";
  }
}

}  // namespace impetus::bids_export_test
