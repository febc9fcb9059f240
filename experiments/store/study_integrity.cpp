// SPDX-License-Identifier: MIT
#include "experiments/store/study_integrity.hpp"

#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>

#include "experiments/store/read_only_file.hpp"

namespace impetus::inline store {
namespace {

void add_damaged_pages_and_values(SQLite::Database& database, std::vector<std::string>& damage) {
  SQLite::Statement query(database, "PRAGMA integrity_check");
  while (query.executeStep()) {
    const std::string found = query.getColumn(0).getString();
    if (found != "ok") {
      damage.push_back("SQLite's check of its integrity: " + found);
    }
  }
}

void add_broken_references(SQLite::Database& database, std::vector<std::string>& damage) {
  SQLite::Statement query(database,
                          "SELECT \"table\", parent, count(*) FROM pragma_foreign_key_check "
                          "GROUP BY \"table\", parent, fkid");
  while (query.executeStep()) {
    const std::int64_t rows = query.getColumn(2).getInt64();
    damage.push_back(std::to_string(rows) + (rows == 1 ? " row" : " rows") + " of " +
                     query.getColumn(0).getString() + (rows == 1 ? " refers" : " refer") +
                     " to a row of " + query.getColumn(1).getString() + " that is missing");
  }
}

}  // namespace

std::vector<std::string> damage_in(SQLite::Database& database) {
  std::vector<std::string> damage;
  try {
    add_damaged_pages_and_values(database, damage);
    add_broken_references(database, damage);
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() != SQLITE_NOTADB) {
      damage.push_back(std::string("it cannot be read whole: ") + error.what());
    }
  }
  return damage;
}

std::vector<std::string> damage_in(const std::filesystem::path& path) {
  try {
    return damage_in(*open_read_only(path));
  } catch (const SQLite::Exception& error) {
    return {std::string("it cannot be read: ") + error.what()};
  }
}

}  // namespace impetus::inline store
