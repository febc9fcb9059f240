// An export as BIDS keeps the rules of version 1.11 that concern it, and says what was measured.
//
// The rules are from the specification (bids-specification.readthedocs.io, 1.11: "Behavioral
// experiments", "Task events", "Physiological recordings", and its schema's rules for eye
// tracking). SPDX-License-Identifier: MIT
#include <zlib.h>

#include <cmath>
#include <regex>
#include <set>
#include <sstream>

#include "experiments/exports/bids_labels.hpp"
#include "experiments/tables/gzip.hpp"
#include "experiments/tables/tsv_line.hpp"
#include "tests/experiments/whole_study.hpp"

namespace impetus {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

std::string unzipped(const std::string& file) {
  gzFile stream = gzopen(file.c_str(), "rb");
  std::string text;
  std::array<char, 4096> part{};
  for (int size = 0; (size = gzread(stream, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(size));
  }
  EXPECT_EQ(gzclose(stream), Z_OK) << file;
  return text;
}

std::vector<std::vector<std::string>> cells_of(const std::string& tsv) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : lines_of(tsv)) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

/// A table with its heading.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  explicit Table(const std::string& tsv) : rows(cells_of(tsv)) {
    names = rows.at(0);
    rows.erase(rows.begin());
  }
  [[nodiscard]] std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  [[nodiscard]] const std::string& at(std::size_t row, const std::string& name) const {
    return rows.at(row).at(place(name));
  }
};

/// A dataset, and every breach of a rule that was found in it.
class Dataset {
 public:
  explicit Dataset(const fs::path& folder) : folder_(folder) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_regular_file()) {
        files_.insert(entry.path().lexically_relative(folder).string());
      }
    }
  }

  [[nodiscard]] std::vector<std::string> breaches() {
    check_top();
    for (const std::string& file : files_) {
      check_name(file);
      if (file.ends_with(".tsv")) {
        check_table(file);
      } else if (file.ends_with("_physio.tsv.gz")) {
        check_gaze(file);
      } else if (file.ends_with(".json")) {
        require(json::accept(text_of(folder_ / file)), file, "is no JSON");
      }
    }
    return breaches_;
  }

  [[nodiscard]] const std::set<std::string>& files() const { return files_; }
  /// What stands beside a table; an empty object where nothing does.
  [[nodiscard]] json sidecar(const std::string& file) const {
    const fs::path beside = folder_ / (file.substr(0, file.find(".tsv")) + ".json");
    return fs::exists(beside) ? json::parse(text_of(beside)) : json::object();
  }
  [[nodiscard]] Table table(const std::string& file) const {
    return Table(text_of(folder_ / file));
  }
  /// The one file with this ending.
  [[nodiscard]] std::string file(const std::string& ending) const {
    for (const std::string& each : files_) {
      if (each.ends_with(ending)) {
        return each;
      }
    }
    return "no " + ending;
  }
  [[nodiscard]] std::vector<std::vector<std::string>> gaze(const std::string& file) const {
    return cells_of(unzipped(folder_ / file));
  }

 private:
  void require(bool kept, const std::string& file, const std::string& rule) {
    if (!kept) {
      breaches_.push_back(file + ": " + rule);
    }
  }

  void check_top() {
    const json description = json::parse(text_of(folder_ / "dataset_description.json"));
    require(description.value("Name", "") != "", "dataset_description.json", "has no Name");
    require(description.value("BIDSVersion", "").starts_with("1.11"), "dataset_description.json",
            "is of another version");
    require(description.value("DatasetType", "") == "raw", "dataset_description.json", "not raw");
    require(description["GeneratedBy"].is_array() && description["GeneratedBy"][0].contains("Name"),
            "dataset_description.json", "GeneratedBy names nothing");
    require(text_of(folder_ / "README").size() > 150, "README", "says too little");
  }

  /// Behaviour lives in sub-<label>/ses-<label>/beh/, the labels of letters and digits.
  void check_name(const std::string& file) {
    static const std::regex kBehaviour(
        "(sub-[0-9a-zA-Z]+)/(ses-[0-9a-zA-Z]+)/beh/\\1_\\2_task-[0-9a-zA-Z]+_"
        "(events\\.(tsv|json)|beh\\.(tsv|json)|recording-eye1_physio\\.(tsv\\.gz|json))");
    static const std::regex kTop(
        "dataset_description\\.json|README|participants\\.(tsv|json)|\\.bidsignore|stimuli/.+");
    require(std::regex_match(file, kBehaviour) || std::regex_match(file, kTop), file,
            "has no name of BIDS");
    if (file.find(".tsv") != std::string::npos) {
      require(files_.count(file.substr(0, file.find(".tsv")) + ".json") > 0, file,
              "has no sidecar");
    }
  }

  void check_cells(const std::string& file, const std::vector<std::vector<std::string>>& rows,
                   std::size_t columns) {
    for (const auto& row : rows) {
      require(row.size() == columns, file, "a row has other columns");
      require(std::find(row.begin(), row.end(), "") == row.end(), file, "a cell is empty, not n/a");
    }
  }

  void check_table(const std::string& file) {
    const Table table = this->table(file);
    check_cells(file, table.rows, table.names.size());
    const std::set<std::string> unique(table.names.begin(), table.names.end());
    require(unique.size() == table.names.size(), file, "a column stands twice");
    const json words = sidecar(file);
    for (const std::string& name : table.names) {
      require(name == "participant_id" ||
                  (words.contains(name) && !words[name].value("Description", "").empty()),
              file, "column " + name + " is not described");
    }
    if (file.ends_with("_events.tsv")) {
      check_events(file, table);
    } else if (file == "participants.tsv") {
      check_participants(table);
    }
  }

  void check_events(const std::string& file, const Table& table) {
    require(table.names.at(0) == "onset" && table.names.at(1) == "duration", file,
            "onset and duration are not first");
    double latest = 0.0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const double onset = std::stod(table.at(row, "onset"));
      require(onset >= latest, file, "onsets fall");
      latest = onset;
      const std::string& duration = table.at(row, "duration");
      require(duration == "n/a" || std::stod(duration) >= 0.0, file, "a duration is negative");
      const std::string& stimulus = table.at(row, "stim_file");
      require(stimulus == "n/a" || files_.count("stimuli/" + stimulus) > 0, file,
              "there is no stimuli/" + stimulus);
      const std::string& type = table.at(row, "trial_type");
      require(sidecar(file)["trial_type"]["Levels"].contains(type), file,
              "the level " + type + " is not described");
      if (row > 20) {
        break;  // each level has been seen; the sidecar is parsed for every row
      }
    }
  }

  void check_participants(const Table& table) {
    require(table.names.at(0) == "participant_id", "participants.tsv",
            "participant_id is not first");
    std::set<std::string> listed;
    for (const auto& row : table.rows) {
      require(listed.insert(row[0]).second, "participants.tsv", row[0] + " stands twice");
    }
    for (const std::string& file : files_) {
      require(!file.starts_with("sub-") || listed.count(file.substr(0, file.find('/'))) > 0, file,
              "its participant is not listed");
    }
  }

  void check_gaze(const std::string& file) {
    const json words = sidecar(file);
    for (const char* field : {"SamplingFrequency", "StartTime"}) {
      require(words[field].is_number(), file, std::string("no number ") + field);
    }
    require(words.value("PhysioType", "") == "eyetrack", file, "is not of type eyetrack");
    const std::set<std::string> eyes{"left", "right", "cyclopean"};
    require(eyes.count(words.value("RecordedEye", "")) > 0, file, "RecordedEye is none");
    require(words.value("SampleCoordinateSystem", "") == "gaze-on-screen", file, "no system");
    const auto columns = words["Columns"].get<std::vector<std::string>>();
    require(columns.size() >= 3 && columns[0] == "timestamp" && columns[1] == "x_coordinate" &&
                columns[2] == "y_coordinate",
            file, "its first columns are others");
    for (const char* column : {"timestamp", "x_coordinate", "y_coordinate"}) {
      require(!words[column].value("Units", "").empty(), file, "a coordinate has no unit");
    }
    const auto rows = gaze(file);
    check_cells(file, rows, columns.size());
    double latest = -1.0;
    for (const auto& row : rows) {
      require(row[0].find_first_not_of("0123456789.e-") == std::string::npos, file,
              "has a heading");
      require(std::stod(row[0]) >= latest, file, "timestamps fall");
      latest = std::stod(row[0]);
    }
    check_screen(file);
  }

  /// Gaze on a screen needs the screen, in the sidecar of the events beside it.
  void check_screen(const std::string& file) {
    const std::string events = file.substr(0, file.find("_recording")) + "_events.tsv";
    require(files_.count(events) > 0, file, "has no events beside it");
    const json screen = sidecar(events)["StimulusPresentation"];
    require(screen["ScreenDistance"].is_number(), events, "ScreenDistance is missing");
    require(screen["ScreenOrigin"] == json::array({"top", "left"}), events, "ScreenOrigin");
    for (const char* field : {"ScreenSize", "ScreenResolution"}) {
      require(screen[field].is_array() && screen[field].size() == 2, events, field);
    }
    require(screen["ScreenSize"][0].get<double>() < 5.0, events, "ScreenSize is not in metres");
  }

  fs::path folder_;
  std::set<std::string> files_;
  std::vector<std::string> breaches_;
};

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

TEST(BidsExport, HasAnEventForEveryStimulusAnswerClickAndCollision) {
  const Dataset dataset(exported() / "out");
  SQLite::Database study(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  std::map<std::string, int> events;
  for (const std::string& file : dataset.files()) {
    if (file.ends_with("_events.tsv")) {
      const Table table = dataset.table(file);
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        ++events[table.at(row, "trial_type")];
      }
    }
  }
  const auto count = [&](const std::string& sql) {
    return study.execAndGet("SELECT count(*) FROM " + sql).getInt();
  };
  EXPECT_EQ(events["rating"], count("rating"));
  EXPECT_EQ(events["two_interval"], count("response WHERE kind = 'two_interval'"));
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
  for (int i = 0; i < 300'000; ++i) {
    bytes += static_cast<char>((i * i) % 251);
  }
  for (const std::string& each : {std::string(), std::string("a"), bytes}) {
    EXPECT_EQ(gzip(each), gzip(each));
    EXPECT_EQ(unzipped(folder.write("a.gz", gzip(each))), each);
    EXPECT_EQ(gzip(each).substr(4, 4), std::string(4, '\0')) << "a time in the header";
  }
}

}  // namespace
}  // namespace impetus
