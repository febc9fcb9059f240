// SPDX-License-Identifier: MIT
#include "experiments/store/migration.hpp"

#include <SQLiteCpp/Transaction.h>

#include <iterator>
#include <string>

#include "experiments/store/embedded_migration_10_11.hpp"
#include "experiments/store/embedded_migration_11_12.hpp"
#include "experiments/store/embedded_migration_12_13.hpp"
#include "experiments/store/embedded_migration_1_2.hpp"
#include "experiments/store/embedded_migration_2_3.hpp"
#include "experiments/store/embedded_migration_3_4.hpp"
#include "experiments/store/embedded_migration_4_5.hpp"
#include "experiments/store/embedded_migration_5_6.hpp"
#include "experiments/store/embedded_migration_6_7.hpp"
#include "experiments/store/embedded_migration_7_8.hpp"
#include "experiments/store/embedded_migration_8_9.hpp"
#include "experiments/store/embedded_migration_9_10.hpp"
#include "experiments/store/embedded_schema.hpp"
#include "experiments/store/embedded_views.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

/// From schema 1 to 2, from 2 to 3, and so on.
constexpr const char* kMigrations[] = {
    kMigrationFrom1To2Sql,   kMigrationFrom2To3Sql,   kMigrationFrom3To4Sql,
    kMigrationFrom4To5Sql,   kMigrationFrom5To6Sql,   kMigrationFrom6To7Sql,
    kMigrationFrom7To8Sql,   kMigrationFrom8To9Sql,   kMigrationFrom9To10Sql,
    kMigrationFrom10To11Sql, kMigrationFrom11To12Sql, kMigrationFrom12To13Sql};
static_assert(std::size(kMigrations) == kSchemaVersion - 1);

/// As SQL names things: a study from elsewhere may have views of any name.
std::string in_quotes(const std::string& name) {
  std::string quoted = "\"";
  for (const char letter : name) {
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return quoted + "\"";
}

void drop_views(SQLite::Database& database) {
  for (const std::string& name :
       load_column<std::string>(database, "SELECT name FROM sqlite_master WHERE type = 'view'")) {
    database.exec("DROP VIEW " + in_quotes(name));
  }
}

/// While tables are copied what refers to them refers to nothing; inside a transaction the pragma
/// would do nothing.
class ForeignKeysOff {
 public:
  explicit ForeignKeysOff(SQLite::Database& database)
      : database_(database), were_on_(database.execAndGet("PRAGMA foreign_keys").getInt() != 0) {
    database_.exec("PRAGMA foreign_keys = OFF");
  }
  ~ForeignKeysOff() {
    if (were_on_) {
      database_.tryExec("PRAGMA foreign_keys = ON");
    }
  }
  ForeignKeysOff(const ForeignKeysOff&) = delete;
  ForeignKeysOff& operator=(const ForeignKeysOff&) = delete;

 private:
  SQLite::Database& database_;
  bool were_on_;
};

/// The first files of schema 1 were made before bodies that cannot turn.
void add_early_missing_column(SQLite::Database& database) {
  const bool has_it = database
                          .execAndGet(
                              "SELECT count(*) FROM pragma_table_info('collision') "
                              "WHERE name = 'imposed_no_spin'")
                          .getInt() > 0;
  if (!has_it) {
    database.exec("ALTER TABLE collision ADD COLUMN imposed_no_spin INTEGER NOT NULL DEFAULT 0");
  }
}

}  // namespace

void create_tables_and_views(SQLite::Database& database) {
  database.exec(kStudySchemaSql);
  database.exec(kStudyViewsSql);
}

void migrate(SQLite::Database& database, std::int64_t version) {
  const ForeignKeysOff copying(database);
  SQLite::Transaction transaction(database);
  drop_views(database);
  for (std::int64_t from = version; from < kSchemaVersion; ++from) {
    if (from == 2) {
      add_early_missing_column(database);
    }
    database.exec(kMigrations[from - 1]);
  }
  database.exec(kStudyViewsSql);
  database.exec("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

}  // namespace impetus::inline store
