// All rows of one study put into another, with ids of their own there.
//
//   id in the source ──+ largest id there before──> id in the destination; references go along
//   a protocol that is there already ─────────────> that one's id
//
// It knows tables by the schema alone: ids are columns called `id`, references are declared.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

namespace impetus::inline store {

/// Copies every row of `source` but that of the table study; of a protocol only what `destination`
/// lacks. References may be broken until the end of the destination's transaction, which must be
/// open. Both are of the present schema. Returns the largest id of a participant that was there
/// before: those beyond it are the source's. Throws SQLite::Exception.
std::int64_t copy_rows(SQLite::Database& source, SQLite::Database& destination);

}  // namespace impetus::inline store
