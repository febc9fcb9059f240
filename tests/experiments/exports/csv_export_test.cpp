// An export as CSV: nothing is lost, every column is explained, and no half of one ever stands.
// SPDX-License-Identifier: MIT
#include <sys/resource.h>

#include <csignal>
#include <set>

#include "experiments/exports/export_table.hpp"
#include "experiments/store/migration.hpp"
#include "experiments/store/schema_words.hpp"
#include "tests/experiments/csv_reading.hpp"
#include "tests/experiments/whole_study.hpp"

namespace impetus::csv_export_test {

using nlohmann::json;

/// The whole study's export, made once.
class Exported {
 public:
  static const Exported& once() {
    static const Exported kExport;
    return kExport;
  }

  [[nodiscard]] CsvTable table(const std::string& file) const {
    return read_csv(text_of(folder_ / ("out/" + file)));
  }
  [[nodiscard]] json codebook() const {
    return json::parse(text_of(folder_ / "out/codebook.json"));
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    return text_of(folder_ / ("out/" + file));
  }
  [[nodiscard]] const ProgramResult& result() const { return result_; }
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "out")) {
      if (entry.is_regular_file()) {
        names.insert(entry.path().lexically_relative(folder_ / "out").string());
      }
    }
    return names;
  }

 private:
  Exported()
      : result_(run_program(folder_, {"export", WholeStudy::once().file(), "--out", "out"})) {}

  TemporaryFolder folder_;
  ProgramResult result_;
};

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> names;
  SQLite::Statement query(database, "SELECT name FROM pragma_table_info(?)");
  query.bind(1, table);
  while (query.executeStep()) {
    names.push_back(query.getColumn(0).getString());
  }
  return names;
}

std::string from_hexadecimal(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

/// Puts a cell back as the value that a column of this type held.
void bind_cell(SQLite::Statement& statement, int place, const CsvCell& cell,
               const std::string& type) {
  if (cell.text.empty() && !cell.quoted) {
    statement.bind(place);
  } else if (type == "TEXT") {
    EXPECT_TRUE(cell.quoted) << cell.text;
    statement.bind(place, cell.text);
  } else if (type == "REAL") {
    statement.bind(place, std::strtod(cell.text.c_str(), nullptr));
  } else if (type == "BLOB") {
    const std::string bytes = from_hexadecimal(cell.text.substr(1));
    statement.bind(place, bytes.data(), static_cast<int>(bytes.size()));
  } else if (cell.text[0] == 'x') {
    statement.bind(place, static_cast<std::int64_t>(std::stoull(cell.text.substr(1), nullptr, 16)));
  } else {
    statement.bind(place, static_cast<std::int64_t>(std::stoll(cell.text)));
  }
}

std::string insertion(const std::string& table, const std::vector<std::string>& columns) {
  std::string names;
  std::string places;
  for (const std::string& column : columns) {
    names += (names.empty() ? "" : ", ") + column;
    places += places.empty() ? "?" : ", ?";
  }
  return "INSERT INTO " + table + " (" + names + ") VALUES (" + places + ")";
}

void fill(SQLite::Database& database, const std::string& table, const CsvTable& csv,
          const std::vector<std::string>& columns, const std::map<std::string, std::string>& from) {
  SQLite::Statement insert(database, insertion(table, columns));
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto other = from.find(columns[i]);
      bind_cell(insert, static_cast<int>(i) + 1,
                csv.at(row, other == from.end() ? columns[i] : other->second),
                schema_words().at(table).at(columns[i]).type);
    }
    insert.exec();
    insert.reset();
  }
}

void fill_protocols(SQLite::Database& database, const Exported& exported) {
  const CsvTable csv = exported.table("protocols.csv");
  SQLite::Statement insert(database, "INSERT INTO protocol VALUES (?, ?, ?, ?, ?)");
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    const std::string id = csv.at(row, "id").text;
    const std::string name = csv.at(row, "name").text;
    const std::string hash = csv.at(row, "hash").text;
    const std::string stem = "protocols/" + id + "-" + name + "-" + hash;
    insert.bind(1, static_cast<std::int64_t>(std::stoll(id)));
    insert.bind(2, name);
    insert.bind(3, hash);
    insert.bind(4, exported.text(stem + ".protocol.json"));
    insert.bind(5, exported.text(stem + ".scene.json"));
    insert.exec();
    insert.reset();
  }
}

/// Where `replay --truth` measured no gap there is no row.
CsvTable measured(CsvTable collisions) {
  CsvTable kept{collisions.names, {}};
  for (std::size_t row = 0; row < collisions.rows.size(); ++row) {
    if (!collisions.at(row, "gap_m").text.empty()) {
      kept.rows.push_back(collisions.rows[row]);
    }
  }
  return kept;
}

/// The study again, in memory, from the export's files alone.
SQLite::Database read_back(const Exported& exported) {
  SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  create_tables_and_views(database);
  for (const ExportTable& table : export_tables()) {
    if (table.base == "protocol") {
      fill_protocols(database, exported);
    } else {
      fill(database, table.base, exported.table(table.file + ".csv"),
           columns_of(database, table.base), {});
    }
  }
  fill(database, "collision_truth", measured(exported.table("collisions.csv")),
       columns_of(database, "collision_truth"), {{"collision_id", "id"}});
  return database;
}

/// Every value of a table with its type, doubles to the bit, in the order of all columns.
std::vector<std::string> values_of(SQLite::Database& database, const std::string& table) {
  std::string cells;
  std::string order;
  for (const std::string& column : columns_of(database, table)) {
    cells += (cells.empty() ? "" : " || '|' || ") + ("typeof(" + column) + ") || ' ' || coalesce(" +
             "CASE typeof(" + column + ") WHEN 'real' THEN printf('%!.20e', " + column +
             ") ELSE hex(" + column + ") END, '')";
    order += (order.empty() ? "" : ", ") + column;
  }
  std::vector<std::string> values;
  SQLite::Statement query(database, "SELECT " + cells + " FROM " + table + " ORDER BY " + order);
  while (query.executeStep()) {
    values.push_back(query.getColumn(0).getString());
  }
  return values;
}

TEST(CsvExport, ReadingItBackGivesEveryValueOfTheStudy) {
  ASSERT_EQ(Exported::once().result().status, 0) << Exported::once().result().errors;
  SQLite::Database original(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  SQLite::Database back = read_back(Exported::once());
  for (const auto& [table, columns] : schema_words()) {
    const std::vector<std::string> expected = values_of(original, table);
    EXPECT_EQ(values_of(back, table), expected) << table;
    if (table != "merged_file") {
      EXPECT_FALSE(expected.empty()) << table << " would prove nothing";
    }
  }
}

TEST(CsvExport, EveryColumnIsExplainedInTheCodebookAndNothingElseIs) {
  const json files = Exported::once().codebook()["files"];
  std::set<std::string> explained;
  for (const ExportTable& table : export_tables()) {
    const std::string name = table.file + ".csv";
    explained.insert(name);
    const json columns = files[name]["columns"];
    const CsvTable csv = Exported::once().table(name);
    EXPECT_EQ(columns.size(), csv.names.size()) << name << ": a name stands twice";
    for (const std::string& column : csv.names) {
      ASSERT_TRUE(columns.contains(column)) << name << " " << column;
      EXPECT_NE(columns[column]["meaning"].get<std::string>(), "") << name << " " << column;
    }
  }
  EXPECT_EQ(files.size(), explained.size());
  std::set<std::string> there = Exported::once().files();
  std::erase_if(there, [](const std::string& file) {
    return file.starts_with("protocols/") || file.starts_with("codebook.");
  });
  EXPECT_EQ(there, explained);
}

TEST(CsvExport, TheCodebookStatesUnitsTypesAndLabels) {
  const json files = Exported::once().codebook()["files"];
  const json trials = files["trials.csv"]["columns"];
  EXPECT_EQ(trials["rating_time_ms"]["unit"].get<std::string>(), "ms");
  EXPECT_EQ(trials["seed"]["type"].get<std::string>(), "bits");
  EXPECT_EQ(trials["factor_delay_ms"]["meaning"].get<std::string>(),
            "level of this factor of the condition: Delay at contact (ms)");
  const json collisions = files["collisions.csv"]["columns"];
  EXPECT_EQ(collisions["impulse_Ns"]["unit"].get<std::string>(), "N s");
  EXPECT_EQ(collisions["collision_speed_deg_s"]["unit"].get<std::string>(), "deg/s");
  EXPECT_EQ(collisions["gap_arcmin"]["unit"].get<std::string>(), "arcmin");
  EXPECT_EQ(collisions["attempt_id"]["meaning"].get<std::string>(),
            "`id` of the row in attempts.csv");
  const std::string page = Exported::once().text("codebook.md");
  EXPECT_NE(page.find("| impulse_Ns | along the normals, sum over contacts | number | N s |"),
            std::string::npos);
}

TEST(CsvExport, ATrialHasOneRowWithItsConditionAndItsAnswer) {
  const CsvTable trials = Exported::once().table("trials.csv");
  SQLite::Database study(WholeStudy::once().file().string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(static_cast<int>(trials.rows.size()),
            study.execAndGet("SELECT count(*) FROM trial").getInt());
  int rated = 0;
  int completed = 0;
  for (std::size_t row = 0; row < trials.rows.size(); ++row) {
    const json condition = json::parse(trials.at(row, "condition").text);
    const bool delayed = condition.contains("delay_ms");
    const CsvCell& cell = trials.at(row, "factor_delay_ms");
    EXPECT_EQ(cell.text, delayed ? condition["delay_ms"].dump() : "");
    const bool shown = !trials.at(row, "attempt_id").text.empty();
    EXPECT_EQ(trials.at(row, "outcome").text, shown ? "completed" : "not shown");
    completed += shown ? 1 : 0;
    rated += trials.at(row, "rating").text.empty() ? 0 : 1;
    EXPECT_EQ(trials.at(row, "excluded").text, trials.at(row, "id").text == "7" ? "1" : "0");
  }
  EXPECT_EQ(rated, study.execAndGet("SELECT count(*) FROM rating").getInt());
  EXPECT_EQ(completed, study.execAndGet("SELECT count(*) FROM attempt").getInt());
}

TEST(CsvExport, ATrialThatWasNotShownIsThere) {
  const TemporaryFolder folder;
  WholeStudy::once().copy_to(folder,
                             "INSERT INTO trial (enrolment_id, slot, phase, repetition, "
                             "condition, seed) VALUES (1, 999, 'main', 1, '{}', -1)");
  run_program(folder, {"export", "a.sqlite", "--out", "out"});
  const CsvTable trials = read_csv(text_of(folder / "out/trials.csv"));
  for (std::size_t row = 0; row < trials.rows.size(); ++row) {
    if (trials.at(row, "slot").text == "999") {
      EXPECT_EQ(trials.at(row, "outcome").text, "not shown");
      EXPECT_EQ(trials.at(row, "seed").text, "xffffffffffffffff");
      EXPECT_EQ(trials.at(row, "clicks").text, "");
      return;
    }
  }
  ADD_FAILURE() << "no such row";
}

TEST(CsvExport, EveryTableOfTheSchemaIsExported) {
  std::set<std::string> exported{"collision_truth"};  // beside each collision
  for (const ExportTable& table : export_tables()) {
    exported.insert(table.base);
  }
  for (const auto& [table, columns] : schema_words()) {
    EXPECT_EQ(exported.count(table), 1U) << table;
  }
}

TEST(CsvExport, AClickIsTimedFromTheStimulus) {
  const CsvTable clicks = Exported::once().table("clicks.csv");
  ASSERT_GT(clicks.rows.size(), 0U);
  for (std::size_t row = 0; row < clicks.rows.size(); ++row) {
    const double time_s = std::stod(clicks.at(row, "stimulus_time_s").text);
    EXPECT_GE(time_s, 0.0);
    EXPECT_LT(time_s, 3.0);  // the stimulus takes one second
  }
}

// ---------------------------------------------------------------- the folder

TEST(CsvExport, AFolderWithFilesIsRefusedAndLeftAsItIs) {
  const TemporaryFolder folder;
  folder.write("out/mine.txt", "mine");
  const std::string study = WholeStudy::once().file();
  const std::string out = (folder / "out").string();
  expect_refused(folder, {"export", study, "--out", "out"},
                 out + ": holds files already and is not overwritten without --force");
  expect_refused(folder, {"export", study, "--out", "out", "--force"},
                 out +
                     ": expected an earlier export to overwrite, got a folder of other files, "
                     "which --force leaves alone");
  folder.write("file", "mine");
  expect_refused(folder, {"export", study, "--out", "file"},
                 (folder / "file").string() + ": expected a folder, got a file");
  EXPECT_EQ(text_of(folder / "out/mine.txt"), "mine");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
}

TEST(CsvExport, AnEarlierExportIsReplacedWholeWithForce) {
  const TemporaryFolder folder;
  const std::string study = WholeStudy::once().file();
  EXPECT_EQ(run_program(folder, {"export", study, "--out", "out/"}).status, 0);
  json book = json::parse(text_of(folder / "out/codebook.json"));
  book["files"]["old.csv"] = book["files"]["notes.csv"];  // a table of an earlier version
  folder.write("out/codebook.json", book.dump());
  folder.write("out/old.csv", "old");
  EXPECT_EQ(run_program(folder, {"export", study, "--out", "out"}).status, 2);
  EXPECT_EQ(run_program(folder, {"export", study, "--out", "out", "--force"}).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "out/old.csv"));
  EXPECT_EQ(text_of(folder / "out/trials.csv"), Exported::once().text("trials.csv"));
}

/// Exports with --force once `name` is there: refused, and what is there stays.
void expect_kept(const TemporaryFolder& folder, const std::string& name) {
  const std::string trials = text_of(folder / "out/trials.csv");
  expect_refused(folder, {"export", WholeStudy::once().file(), "--out", "out", "--force"},
                 (folder / "out").string() +
                     ": expected an earlier export to overwrite, got one that also holds " + name +
                     ", which no export wrote");
  EXPECT_TRUE(std::filesystem::exists(folder / ("out/" + name)));
  EXPECT_EQ(text_of(folder / "out/trials.csv"), trials);
  std::filesystem::remove(folder / ("out/" + name));
}

TEST(CsvExport, AnEarlierExportThatHoldsSomethingElseIsLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string study = WholeStudy::once().file();
  ASSERT_EQ(run_program(folder, {"export", study, "--out", "out"}).status, 0);
  for (const char* mine : {"notes.txt", "mine.csv", "protocols/mine.protocol.json", "README"}) {
    folder.write("out/" + std::string(mine), "mine");
    expect_kept(folder, mine);
  }
  std::filesystem::create_directory(folder / "out/mydir");
  expect_kept(folder, "mydir/");
  std::filesystem::create_directory_symlink(folder.path(), folder / "out/link");
  expect_kept(folder, "link");
  EXPECT_EQ(run_program(folder, {"export", study, "--out", "out", "--force"}).status, 0);
}

TEST(CsvExport, AFolderWithACodebookOfItsOwnIsNoExport) {
  const TemporaryFolder folder;
  folder.write("out/codebook.json", R"({"about": "my data", "files": {"codebook.json": {}}})");
  expect_refused(folder, {"export", WholeStudy::once().file(), "--out", "out", "--force"},
                 (folder / "out").string() +
                     ": expected an earlier export to overwrite, got a folder of other files, "
                     "which --force leaves alone");
}

TEST(CsvExport, ADiskThatFillsLeavesNoHalfExport) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"export", WholeStudy::once().file(), "--out", "out"}, [] {
        const rlimit limit{20'000, 20'000};  // bytes that a file may have
        setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_IGN);
      });
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("cannot be written"), std::string::npos) << result.errors;
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    left.insert(entry.path().filename());
  }
  EXPECT_EQ(left, (std::set<std::string>{"stderr", "stdout"}));
}

TEST(CsvExport, WhatIsNoStudyIsRefusedAndNoFolderIsMade) {
  const TemporaryFolder folder;
  expect_refused(folder, {"export", "none.sqlite", "--out", "out"},
                 "none.sqlite: expected an Impetus study, but there is no such file");
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace impetus::csv_export_test
