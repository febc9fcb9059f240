// The mark of trials in which a body's state was not finite: a note of the session for each.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

/// Whether a body was taken out in any step of the attempt.
bool has_not_finite(const AttemptRecord& attempt);

/// A note of kind "not finite" for each body that was taken out, such as "trial 3, attempt 1, step
/// 12: red, linear momentum". Throws SQLite::Exception.
void insert_not_finite_notes(SQLite::Database& database, std::int64_t session_id,
                             const AttemptRecord& attempt);

}  // namespace impetus::inline store
