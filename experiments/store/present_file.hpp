// A study whose file is removed, renamed or replaced while a session writes to it: SQLite goes on
// writing to the file that nobody can find any more, so it is noticed here, and all is kept.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>

namespace impetus::inline store {

/// Whether `path` still names the file that is open as `descriptor`.
bool is_present(const std::filesystem::path& path, int descriptor);

/// Writes the whole study beside where it was, as "study.rescued.sqlite" or, where there is such a
/// file, "study.rescued-2.sqlite", ...; returns that path. Throws SQLite::Exception.
std::filesystem::path rescue(SQLite::Database& database, const std::filesystem::path& path);

}  // namespace impetus::inline store
