// A run through the points of a calibration, as rows.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

/// Throws SQLite::Exception.
void insert_calibration(SQLite::Database& database, std::int64_t session_id,
                        const CalibrationRecord& record);

}  // namespace impetus::inline store
