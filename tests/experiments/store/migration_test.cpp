// Studies of an older schema: read from a copy, written only once the original is kept.
// SPDX-License-Identifier: MIT
#include "experiments/store/migration.hpp"

#include "experiments/store/rows.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::migration_test {

/// A recording of each of the first schemas, and one of the first files of schema 1.
constexpr const char* kEarliest = "tests/recordings/causality.sqlite";
constexpr const char* kSchema1 = "tests/recordings/gap.sqlite";
constexpr const char* kSchema2 = "tests/recordings/gaze-contingent.sqlite";
constexpr const char* kSchema3 = "tests/recordings/every-option.sqlite";
constexpr const char* kSchema4 = "tests/recordings/gap-thresholds.sqlite";

std::filesystem::path old_study(const TemporaryFolder& folder, const char* recording = kSchema1) {
  std::filesystem::path path = folder / "old.sqlite";
  std::filesystem::copy_file(source_file(recording), path);
  return path;
}

/// The tables' and views' columns, whatever their order.
std::string columns_of(SQLite::Database& database) {
  return database
      .execAndGet(
          "SELECT group_concat(words, char(10)) FROM (SELECT m.name || '.' || c.name || ' ' "
          "|| c.type || ' ' || c.\"notnull\" AS words FROM sqlite_master AS m, "
          "pragma_table_info(m.name) AS c WHERE m.type IN ('table', 'view') ORDER BY words)")
      .getString();
}

TEST(Migration, ReadingAnOlderStudyLeavesTheFileAsItIs) {
  const TemporaryFolder folder;
  const std::filesystem::path path = old_study(folder);
  ASSERT_EQ(value_of(path, "PRAGMA user_version"), "1");
  const std::string before = text_of(path);
  StudyFile study = StudyFile::open_for_reading(path);
  EXPECT_GT(load_attempts(study).size(), 0U);
  EXPECT_EQ(study.database().execAndGet("SELECT count(*) FROM gaze_step").getInt(), 0);
  EXPECT_EQ(text_of(path), before);
}

TEST(Migration, AMigratedStudyHasTheColumnsOfANewOne) {
  for (const char* recording : {kEarliest, kSchema1, kSchema2, kSchema3, kSchema4}) {
    const TemporaryFolder folder;
    StudyFile migrated = StudyFile::open_for_reading(old_study(folder, recording));
    StudyFile fresh = opened(folder / "new.sqlite");
    EXPECT_EQ(columns_of(migrated.database()), columns_of(fresh.database()));
  }
}

/// A study of a schema after 4: what the scripts from each to the next alone make of one of 4.
std::filesystem::path study_of_schema(const TemporaryFolder& folder, std::int64_t version) {
  const std::filesystem::path path = old_study(folder, kSchema4);
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  for (const std::string& view :
       load_column<std::string>(database, "SELECT name FROM sqlite_master WHERE type = 'view'")) {
    database.exec("DROP VIEW " + view);
  }
  for (std::int64_t from = 4; from < version; ++from) {
    const std::string name = std::to_string(from) + "_" + std::to_string(from + 1);
    database.exec(text_of(source_file("experiments/store/migration_" + name + ".sql")));
  }
  database.exec("PRAGMA user_version = " + std::to_string(version));
  return path;
}

TEST(Migration, AStudyOfEachLaterSchemaHasThemToo) {
  for (std::int64_t version = 5; version < kSchemaVersion; ++version) {
    SCOPED_TRACE("schema " + std::to_string(version));
    const TemporaryFolder folder;
    StudyFile migrated = StudyFile::open_for_reading(study_of_schema(folder, version));
    StudyFile fresh = opened(folder / "new.sqlite");
    EXPECT_EQ(columns_of(migrated.database()), columns_of(fresh.database()));
    EXPECT_GT(load_attempts(migrated).size(), 0U);
  }
}

TEST(Migration, CollisionsKeepTheirIdsValuesAndTruths) {
  const char* const kCollisions =
      "SELECT group_concat(id || body_a || body_b || level || stopped || hex(depth_m) || list, "
      "'|') "
      "FROM collision";
  const TemporaryFolder folder;
  const std::filesystem::path path = old_study(folder, kSchema2);
  ASSERT_EQ(value_of(path, "PRAGMA user_version"), "2");
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec("INSERT INTO collision_truth SELECT id, 0, 0, 0, 0 FROM collision");
  const std::string before = value_of(path, kCollisions);
  ASSERT_FALSE(before.empty());
  { opened(path); }
  EXPECT_EQ(value_of(path, kCollisions), before);
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM pragma_foreign_key_check"), "0");
  EXPECT_EQ(value_of(path, "SELECT sum(contacts) = count(*) FROM seen_collision"), "1");
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM collision_truth"),
            value_of(path, "SELECT count(*) FROM collision"));
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM popped_step"), "0");
}

/// Every value of the columns that a table had in the schema of `original`, row by row.
std::string rows_of(const std::filesystem::path& path, const std::filesystem::path& original,
                    const std::string& table) {
  const std::string columns = value_of(
      original,
      "SELECT group_concat('quote(' || name || ')', '||''|''||') FROM pragma_table_info('" + table +
          "')");
  return value_of(path, "SELECT group_concat(row, char(10)) FROM (SELECT " + columns +
                            " AS row FROM " + table + " ORDER BY 1)");
}

TEST(Migration, FromSchema4EveryRowOfEveryTableStays) {
  const TemporaryFolder folder;
  const std::filesystem::path original = source_file(kSchema4);
  ASSERT_EQ(value_of(original, "PRAGMA user_version"), "4");
  const std::filesystem::path path = old_study(folder, kSchema4);
  { opened(path); }
  EXPECT_EQ(value_of(path, "PRAGMA user_version"), "13");
  for (const char* table : {"study", "protocol", "participant", "enrolment", "session", "trial",
                            "attempt", "step", "collision", "response", "note"}) {
    const std::string before = rows_of(original, original, table);
    EXPECT_EQ(rows_of(path, original, table), before) << table;
  }
  EXPECT_FALSE(rows_of(original, original, "attempt").empty());
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM pragma_foreign_key_check"), "0");
  EXPECT_EQ(value_of(path, "PRAGMA integrity_check"), "ok");
}

TEST(Migration, ASessionOfAnOlderStudyMayEndAsDeclined) {
  const TemporaryFolder folder;
  const std::filesystem::path path = old_study(folder, kSchema4);
  { opened(path); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE session SET ending = 'declined' WHERE id = 1");
  EXPECT_EQ(value_of(path, "SELECT ending FROM session WHERE id = 1"), "declined");
}

TEST(Migration, WritingToAnOlderStudyKeepsTheOriginalBesideIt) {
  const TemporaryFolder folder;
  const std::filesystem::path path = old_study(folder);
  const std::string ratings = value_of(path, "SELECT group_concat(rating) FROM rating");
  { opened(path); }
  EXPECT_EQ(value_of(path, "PRAGMA user_version"), "13");
  EXPECT_EQ(value_of(path, "SELECT group_concat(rating) FROM rating"), ratings);
  const std::filesystem::path kept = folder / "old.schema-1.sqlite";
  EXPECT_EQ(value_of(kept, "PRAGMA user_version"), "1");
  EXPECT_EQ(value_of(kept, "SELECT group_concat(rating) FROM rating"), ratings);
  EXPECT_EQ(value_of(path, "SELECT count(*) FROM pragma_foreign_key_check"), "0");
}

TEST(Migration, AFileInTheWayOfTheKeptOriginalIsNotOverwritten) {
  const TemporaryFolder folder;
  const std::filesystem::path path = old_study(folder);
  const std::filesystem::path kept = folder.write("old.schema-1.sqlite", "mine");
  const std::string before = text_of(path);
  EXPECT_EQ(open_refusal(path),
            path.string() + ": expected to keep it, of schema version 1, as " + kept.string() +
                " before it is brought to version 13, but there is such a file");
  EXPECT_EQ(text_of(kept), "mine");
  EXPECT_EQ(value_of(path, "PRAGMA user_version"), "1");
}

}  // namespace impetus::migration_test
