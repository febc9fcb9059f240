// Whether a study file is whole: as a file, as a database, and with the tables and views that this
// build makes, none of them added, dropped or loosened by hand.
//
// Tables are compared by what they mean (columns, keys, checks), for a migrated one has other
// words; views and indexes by their words.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <string>
#include <vector>

namespace impetus::inline store {

/// How the sentence ends of what a study lacks altogether.
inline constexpr const char* kIsMissing = " is missing";

/// What differs, each in one sentence; nothing when all is as it should be. Throws
/// SQLite::Exception.
std::vector<std::string> schema_differences(SQLite::Database& study);

/// Rows that break a CHECK of a table, each check in one sentence. SQLite's own check of a file's
/// integrity leaves that out where the file is only read. Throws SQLite::Exception. Precondition:
/// the schema has no differences.
std::vector<std::string> forbidden_rows(SQLite::Database& study);

/// A column and the table whose id it holds.
struct Reference {
  std::string column;
  std::string table;
};

/// Names of the study's tables, in alphabetical order. Throws SQLite::Exception.
std::vector<std::string> table_names(SQLite::Database& database);

/// Names of a table's columns, in their order. Throws SQLite::Exception.
std::vector<std::string> column_names(SQLite::Database& database, const std::string& table);

/// The columns of a table that refer to other rows' ids. Throws SQLite::Exception.
std::vector<Reference> references_of(SQLite::Database& database, const std::string& table);

/// What SQLite finds damaged: pages, indexes, values that a table does not allow, rows that refer
/// to none. Each in one sentence; nothing when the file is whole.
std::vector<std::string> damage_in(SQLite::Database& database);

/// The same of a file, which is not changed. What is no database at all is not damaged: opening it
/// as a study says so.
std::vector<std::string> damage_in(const std::filesystem::path& path);

}  // namespace impetus::inline store
