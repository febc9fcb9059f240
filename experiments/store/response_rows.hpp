// What a participant answered in an attempt as rows: clicks, ratings and every other response.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

/// Inserts clicks, ratings and responses, each numbered from 1 in its order. Throws
/// SQLite::Exception.
void insert_answers(SQLite::Database& database, std::int64_t attempt_id,
                    const AttemptRecord& attempt);

/// {"name": value, ...} in this order; whole numbers without a decimal point. Throws
/// SQLite::Exception.
std::string json_object_of(SQLite::Database& database, const std::vector<FactorLevel>& values);

}  // namespace impetus::inline store
