// Brings an older study file to the present schema; nothing that was recorded changes.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

namespace impetus::inline store {

inline constexpr std::int64_t kSchemaVersion = 13;
inline constexpr std::int64_t kOldestSchemaVersion = 1;

/// Makes tables and views of the present schema in an empty database. Throws SQLite::Exception.
void create_tables_and_views(SQLite::Database& database);

/// From `version` (kOldestSchemaVersion ... kSchemaVersion − 1) to the present one, as a whole or
/// not at all. Throws SQLite::Exception. Precondition: no transaction is open.
void migrate(SQLite::Database& database, std::int64_t version);

}  // namespace impetus::inline store
