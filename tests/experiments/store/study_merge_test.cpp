// `impetus merge`: everything of every table arrives, or nothing does.
// SPDX-License-Identifier: MIT
#include "experiments/store/merging/study_merge.hpp"

#include <sys/stat.h>

#include <map>
#include <set>

#include "experiments/store/merging/merge_part.hpp"
#include "experiments/store/study_integrity.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/small_study.hpp"

namespace impetus::study_merge_test {

using Rows = std::multiset<std::string>;

/// A whole study with at least one row in every table there is.
std::filesystem::path study_with_every_table(const std::filesystem::path& path,
                                             const std::string& person) {
  small_study(path, {person});
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA foreign_keys = ON");
  database.exec(
      "INSERT INTO merged_file VALUES (7, 'earlier.sqlite', 'hash of " + person + "', 'then', " +
      "'a build', 'later'); INSERT INTO participant VALUES (9, '" + person + " earlier', 1, 7); " +
      "INSERT INTO collision_truth SELECT id, .1, .2, .3, .4 FROM collision; "
      "INSERT INTO attempt SELECT 50, trial_id, session_id, 2, 'set aside', onset_ns, "
      "intended_hold_ms, realised_hold_ms, timed_frames, late_timed_frames, late_untimed_frames, "
      "sync_overridden, gaze_source, gaze_latency_p95_ms, gaze_late, region_covered_share, "
      "interrupted_by, gaze_lost_share, imposed_gaze_latency_ms, saved_utc, session_id "
      "FROM attempt WHERE id = 2; "
      "UPDATE trial SET yoked_trial_id = 4 WHERE id = 2; "
      "INSERT INTO gaze VALUES (3, 1, 11, .5, .25, NULL, 1); "
      "INSERT INTO click VALUES (3, 1, 'key', 12, 13, 1); "
      "INSERT INTO marker VALUES (3, 1, 'contact', 30, 12, 13, 1); "
      "INSERT INTO sound VALUES (3, 1, 240, -150, 0.5, 12, 13, 14, 1); "
      "INSERT INTO response VALUES (3, 1, 'free_text', 'Why?', 'for ''' || char(10) || 'fun', "
      "NULL, "
      "NULL, '{}', 'key', 1, 2, 3, 0); "
      "INSERT INTO calibration (id, session_id, kind, number, before_slot, gaze_source, "
      "lost_share, "
      "accuracy_limit_deg, passed, began_ns) VALUES (5, 1, 'calibration', 1, 1, 'mouse', 0, 1, 1, "
      "2); "
      "INSERT INTO calibration_point (calibration_id, point, x_m, y_m, samples, lost) "
      "VALUES (5, 1, 0, 0, 9, 0); "
      "INSERT INTO note VALUES (3, 1, 'then', 'gaze lost', 'trial 2'); "
      "INSERT INTO exclusion VALUES (2, 1, 3, 1, 'a reason', 'then')");
  return path;
}

/// The rows of a study's tables, each with what it refers to in place of ids: so rows of two files
/// can be told to be the same.
class RowsWithoutIds {
 public:
  explicit RowsWithoutIds(const std::filesystem::path& path)
      : database_(path.string(), SQLite::OPEN_READONLY) {
    for (const std::string& table : table_names(database_)) {
      load(table);
    }
  }

  [[nodiscard]] const std::map<std::string, Rows>& tables() const { return rows_; }

 private:
  void load(const std::string& table) {
    if (rows_.count(table) > 0) {
      return;
    }
    rows_[table] = {};
    const std::vector<std::string> columns = column_names(database_, table);
    std::map<std::string, std::string> refers_to;
    for (const Reference& reference : references_of(database_, table)) {
      refers_to[reference.column] = reference.table;
    }
    std::string sql = "SELECT 0";
    for (const std::string& column : columns) {
      sql += ", quote(\"" + column + "\")";
    }
    SQLite::Statement query(database_, sql + " FROM \"" + table + "\"");
    while (query.executeStep()) {
      std::string row;
      std::string id;
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string value = query.getColumn(static_cast<int>(i) + 1).getString();
        const auto reference = refers_to.find(columns[i]);
        if (columns[i] == "id") {
          id = value;
        } else if (table == "participant" && columns[i] == "merged_file_id") {
          continue;  // where it came from is what a merge adds
        } else if (reference == refers_to.end() || value == "NULL") {
          row += value + "|";
        } else {
          row += the_row(reference->second, value, table) + "|";
        }
      }
      const std::string hash = std::to_string(std::hash<std::string>()(row));
      known_[table + id] = hash;
      rows_[table].insert(row.substr(0, 60) + hash);
    }
  }

  /// A hash of the row that is referred to; within one table, only that there is one.
  std::string the_row(const std::string& table, const std::string& id, const std::string& from) {
    if (table == from) {
      SQLite::Statement query(database_, "SELECT slot FROM " + table + " WHERE id = " + id);
      query.executeStep();
      return "slot " + query.getColumn(0).getString();
    }
    load(table);
    return known_.at(table + id);
  }

  SQLite::Database database_;
  std::map<std::string, Rows> rows_;
  std::map<std::string, std::string> known_;  ///< hash of a row, by table and id
};

/// Rows of a view without the columns that name rows of other files differently.
Rows rows_of_view(SQLite::Database& database, const std::string& view) {
  static const std::set<std::string> ids{"trial",        "session",     "calibration",
                                         "set_aside_in", "merged_from", "merged_hash",
                                         "merged_utc"};
  std::string columns = "''";
  for (const std::string& column : column_names(database, view)) {
    columns += ids.count(column) > 0 ? "" : " || '|' || quote(\"" + column + "\")";
  }
  SQLite::Statement query(database, "SELECT " + columns + " FROM \"" + view + "\"");
  Rows rows;
  while (query.executeStep()) {
    rows.insert(query.getColumn(0).getString());
  }
  return rows;
}

/// Two files of stations and the folder they are in.
struct Stations {
  TemporaryFolder folder;
  std::filesystem::path a = small_study(folder / "a.sqlite", {"P01"});
  std::filesystem::path b = small_study(folder / "b.sqlite", {"P02"});
  std::filesystem::path into = folder / "all.sqlite";

  std::string refusal(const std::vector<std::filesystem::path>& sources) const {
    return sentence_of([&] { merge_studies(sources, into, kTestBuild); });
  }
};

TEST(Merge, EverythingOfEveryTableArrives) {
  const TemporaryFolder folder;
  const std::filesystem::path a = study_with_every_table(folder / "a.sqlite", "P01");
  const std::filesystem::path b = study_with_every_table(folder / "b.sqlite", "P02");
  const std::filesystem::path into = folder / "all.sqlite";
  merge_studies({a, b}, into, kTestBuild);
  const auto from_a = RowsWithoutIds(a).tables();
  const auto from_b = RowsWithoutIds(b).tables();
  auto merged = RowsWithoutIds(into).tables();
  for (const auto& [table, rows] : from_a) {
    ASSERT_FALSE(rows.empty()) << table << " is empty: what a merge does with it is not tested";
    if (table == "study") {
      continue;  // what the files were stands in merged_file
    }
    Rows both = rows;
    if (table != "protocol") {
      both.insert(from_b.at(table).begin(), from_b.at(table).end());
    }
    for (const std::string& row : both) {
      const auto found = merged[table].find(row);
      ASSERT_NE(found, merged[table].end()) << table << " lacks " << row;
      merged[table].erase(found);
    }
    const std::size_t own = table == "merged_file" ? 2 : 0;  // a and b themselves
    EXPECT_EQ(merged[table].size(), own) << table;
    if (table == "protocol") {
      EXPECT_EQ(value_of(into, "SELECT count(*) FROM protocol"), "1");
    }
  }
  EXPECT_EQ(value_of(into, "SELECT count(*) FROM pragma_foreign_key_check"), "0");
}

TEST(Merge, TheViewsHoldWhatTheSourcesViewsHold) {
  const TemporaryFolder folder;
  const std::filesystem::path a = study_with_every_table(folder / "a.sqlite", "P01");
  const std::filesystem::path b = study_with_every_table(folder / "b.sqlite", "P02");
  merge_studies({a, b}, folder / "all.sqlite", kTestBuild);
  SQLite::Database in_a(a.string(), SQLite::OPEN_READONLY);
  SQLite::Database in_b(b.string(), SQLite::OPEN_READONLY);
  SQLite::Database merged((folder / "all.sqlite").string(), SQLite::OPEN_READONLY);
  SQLite::Statement views(merged, "SELECT name FROM sqlite_master WHERE type = 'view'");
  int compared = 0;
  while (views.executeStep()) {
    const std::string view = views.getColumn(0).getString();
    Rows both = rows_of_view(in_a, view);
    both.merge(rows_of_view(in_b, view));
    EXPECT_EQ(rows_of_view(merged, view), both) << view;
    compared += both.empty() ? 0 : 1;
  }
  EXPECT_GE(compared, 12);
}

TEST(Merge, EachParticipantKeepsTheFileTheyCameFrom) {
  const Stations at;
  const std::filesystem::path c = small_study(at.folder / "c.sqlite", {"P03"});
  merge_studies({at.a, at.b}, at.into, kTestBuild);
  merge_studies({at.into, c}, at.folder / "twice.sqlite", kTestBuild);
  EXPECT_EQ(value_of(at.folder / "twice.sqlite",
                     "SELECT group_concat(pseudonym || ' ' || name, ', ') FROM participant "
                     "JOIN merged_file ON merged_file.id = merged_file_id"),
            "P01 a.sqlite, P02 b.sqlite, P03 c.sqlite");
}

TEST(Merge, AProtocolThatWasChangedByHandIsRefused) {
  const TemporaryFolder folder;
  small_study(folder / "a.sqlite", {"P01"});
  small_study(folder / "b.sqlite", {"P02"});
  tamper(folder / "b.sqlite",
         "UPDATE protocol SET protocol_json = replace(protocol_json, "
         "'\"small\"', '\"Small\"')");
  for (const auto& [first, second] :
       {std::pair{"a.sqlite", "b.sqlite"}, std::pair{"b.sqlite", "a.sqlite"}}) {
    const ProgramResult result =
        run_program(folder, {"merge", first, second, "--into", "c.sqlite"});
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.errors,
              "impetus: b.sqlite: its protocol causality was changed by hand, its hash tells\n");
    EXPECT_FALSE(std::filesystem::exists(folder / "c.sqlite"));
  }
}

TEST(Merge, AMergedStudyReplaysAndPassesItsVerification) {
  const Stations at;
  const ProgramResult merged =
      run_program(at.folder, {"merge", "a.sqlite", "b.sqlite", "--into", "all.sqlite"});
  EXPECT_EQ(merged.errors, "");
  EXPECT_EQ(merged.output,
            "all.sqlite: 2 participants added; it holds 2, with 10 completed trials. The merged "
            "files are as they were.\n");
  const ProgramResult replayed = run_program(at.folder, {"replay", "all.sqlite"});
  EXPECT_EQ(replayed.output.rfind("10 trials, ", 0), 0U) << replayed.output;
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
  EXPECT_EQ(run_program(at.folder, {"verify", "all.sqlite", "--replay"}).status, 0);
}

TEST(Merge, AddsToAStudyThatIsThere) {
  const Stations at;
  const MergeResult result = merge_studies({at.b}, at.a, kTestBuild);
  EXPECT_EQ(result.participants_added, 1);
  EXPECT_EQ(result.participants, 2);
  EXPECT_EQ(value_of(at.a,
                     "SELECT group_concat(participant || completed_trials) FROM "
                     "enrolment_summary"),
            "P014,P024");
  // Who was there before was recorded in this file.
  EXPECT_EQ(value_of(at.a, "SELECT count(*) FROM participant WHERE merged_file_id IS NULL"), "1");
}

TEST(Merge, TheSourcesStayAsTheyAre) {
  const Stations at;
  const std::string before_a = text_of(at.a);
  const std::string before_b = text_of(at.b);
  merge_studies({at.a, at.b}, at.into, kTestBuild);
  EXPECT_EQ(text_of(at.a), before_a);
  EXPECT_EQ(text_of(at.b), before_b);
}

TEST(Merge, AStudyOfAnOlderSchemaCanBeASource) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(source_file("tests/recordings/gap.sqlite"), folder / "old.sqlite");
  merge_studies({folder / "old.sqlite"}, folder / "all.sqlite", kTestBuild);
  EXPECT_EQ(value_of(folder / "all.sqlite", "SELECT count(*) FROM attempt"), "33");
  EXPECT_EQ(value_of(folder / "old.sqlite", "PRAGMA user_version"), "1");
}

TEST(Merge, WhatIsNotOneStudyIsRefusedBeforeAnythingIsWritten) {
  const Stations at;
  const std::string a = at.a.string();
  const std::string b = at.b.string();
  const auto file = [&](const std::string& name) { return at.folder / name; };
  const std::filesystem::path version =
      small_study(file("version.sqlite"), {"P03"}, small_protocol("revised"));
  const std::filesystem::path gap =
      small_study(file("gap.sqlite"), {"P04"}, small_protocol("small", "gap"));
  const std::filesystem::path same_person = small_study(file("person.sqlite"), {"P01", "P05"});
  const std::filesystem::path two = small_study(file("two.sqlite"), {"P06", "P07"});
  const std::filesystem::path same_two = small_study(file("same.sqlite"), {"P07", "P06", "P08"});
  std::filesystem::copy_file(at.a, file("copy.sqlite"));
  ASSERT_EQ(mkfifo(file("pipe.sqlite").c_str(), 0600), 0);
  const std::string hash = small_protocol().hash;
  const std::vector<std::pair<std::vector<std::filesystem::path>, std::string>> cases{
      {{at.a, file("copy.sqlite")}, file("copy.sqlite").string() + ": the same file as " + a},
      {{at.a, version},
       version.string() + ": expected the version of causality that " + a + " holds (" + hash +
           "), got " + small_protocol("revised").hash},
      {{at.a, gap},
       gap.string() + ": expected protocols of the same study as " + a + " (causality), got gap"},
      {{at.a, same_person},
       same_person.string() + ": expected other participants than in " + a + ", got P01 in both"},
      {{two, same_two},
       same_two.string() + ": expected other participants than in " + two.string() +
           ", got P06 in both (and 1 more)"},
      {{at.a, file("none.sqlite")},
       file("none.sqlite").string() + ": expected an Impetus study, but there is no such file"},
      {{at.a, file("pipe.sqlite")},
       file("pipe.sqlite").string() +
           ": expected a file of an Impetus study, got something that is not a file"}};
  for (const auto& [sources, sentence] : cases) {
    EXPECT_EQ(at.refusal(sources), sentence);
    EXPECT_FALSE(std::filesystem::exists(at.into)) << sentence;
  }
}

TEST(Merge, WhatWasMergedBeforeIsRefused) {
  const Stations at;
  merge_studies({at.a}, at.into, kTestBuild);
  const std::string before = text_of(at.into);
  const std::string when = value_of(at.into, "SELECT merged_utc FROM merged_file");
  EXPECT_EQ(at.refusal({at.b, at.a}), at.a.string() + ": was merged into " + at.into.string() +
                                          " already, as a.sqlite at " + when);
  EXPECT_EQ(text_of(at.into), before);
  EXPECT_EQ(at.refusal({at.into}),
            "--into " + at.into.string() + ": expected a study other than those that are merged");
}

TEST(Merge, WhatIsInUseDamagedChangedOrAnonymisedIsRefused) {
  const Stations at;
  {
    const StudyFile running = opened(at.b);
    EXPECT_EQ(in_child([&] {
                return at.refusal({at.a, at.b});
              }),
              at.b.string() + ": in use by another Impetus process; end that session first");
  }
  tamper(at.b, "UPDATE study SET anonymised_by = 'a build'");
  EXPECT_EQ(at.refusal({at.a, at.b}),
            at.b.string() + ": expected a study that is not anonymised; merge first");
  tamper(at.b, "DROP VIEW rated_trial");
  EXPECT_EQ(
      at.refusal({at.a, at.b}),
      at.b.string() + ": expected a study that is whole, but the view rated_trial is missing");
  tamper(at.b, "DELETE FROM session");
  EXPECT_EQ(at.refusal({at.a, at.b}),
            at.b.string() +
                ": expected a study that is whole, but 5 rows of answer refer to a "
                "row of session that is missing (and 1 more)");
  EXPECT_FALSE(std::filesystem::exists(at.into));
}

// By it a destination is known again that was another when the studies were compared.
TEST(Merge, AStudyIsIdentifiedByItsProtocolsPeopleAndEarlierMerges) {
  const Stations at;
  StudyFile empty = opened(at.folder / "empty.sqlite");
  EXPECT_EQ(identity_of(empty), StudyIdentity{});
  StudyFile a = StudyFile::open_for_reading(at.a);
  EXPECT_EQ(identity_of(a).pseudonyms, std::set<std::string>{"P01"});
  EXPECT_EQ(identity_of(a).protocols.at("causality"), std::set<std::string>{small_protocol().hash});
  merge_studies({at.a}, at.into, kTestBuild);
  StudyFile merged = StudyFile::open_for_reading(at.into);
  EXPECT_NE(identity_of(merged), identity_of(a));
  EXPECT_EQ(identity_of(merged).merged.at(hash_of_file(at.a)).name, "a.sqlite");
}

TEST(Merge, AFullDiskLeavesNothingOfANewStudyAndAnOldOneAsItWas) {
  const Stations at;
  // Bytes of any one file: room for a new study's tables or for a log to begin, not for the rows.
  const std::vector<std::pair<std::filesystem::path, rlim_t>> cases{{at.into, 300000},
                                                                    {at.a, 60000}};
  for (const auto& [into, most_bytes] : cases) {
    const std::filesystem::path path = into;
    const rlimit limit{most_bytes, most_bytes};
    const std::string sentence = in_child([&] {
      std::signal(SIGXFSZ, SIG_IGN);
      setrlimit(RLIMIT_FSIZE, &limit);
      return sentence_of([&] { merge_studies({at.b}, path, kTestBuild); });
    });
    EXPECT_EQ(sentence.rfind(path.string() + ": could not be written (", 0), 0U) << sentence;
    EXPECT_NE(sentence.find("); nothing was merged"), std::string::npos) << sentence;
  }
  EXPECT_FALSE(std::filesystem::exists(at.into));
  EXPECT_EQ(value_of(at.a, "SELECT count(*) FROM participant"), "1");
  EXPECT_EQ(value_of(at.a, "PRAGMA integrity_check"), "ok");
}

}  // namespace impetus::study_merge_test
