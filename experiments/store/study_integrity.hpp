// Whether a study file is whole as a file and as a database, whatever stands in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <string>
#include <vector>

namespace impetus::inline store {

/// What SQLite finds damaged: pages, indexes, values that a table does not allow, rows that refer
/// to none. Each in one sentence; nothing when the file is whole.
std::vector<std::string> damage_in(SQLite::Database& database);

/// The same of a file, which is not changed. What is no database at all is not damaged: opening it
/// as a study says so.
std::vector<std::string> damage_in(const std::filesystem::path& path);

}  // namespace impetus::inline store
