// The steps of an attempt as rows: what a replay feeds the world, and the proof of what came out.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

/// Throws SQLite::Exception.
void insert_steps(SQLite::Database& database, std::int64_t attempt_id,
                  const std::vector<StepRecord>& steps);

/// Those of one interval, in order; a trial with one stimulus has interval 1 alone. Throws
/// SQLite::Exception.
std::vector<StepRecord> load_steps(SQLite::Database& database, std::int64_t attempt_id,
                                   std::int64_t interval = 1);

}  // namespace impetus::inline store
