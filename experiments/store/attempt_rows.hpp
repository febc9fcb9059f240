// One attempt at a trial as rows of the study file.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

struct AttemptOwner {
  std::int64_t trial_id{0};
  std::int64_t session_id{0};
  bool sync_overridden{false};
};

/// How many of its timed frames were late.
std::int64_t late_frames(const AttemptRecord& attempt);

/// Inserts the attempt with its steps, collisions, frames, gaze, clicks and answers. Throws
/// SQLite::Exception.
void insert_attempt(SQLite::Database& database, const AttemptOwner& owner,
                    const AttemptRecord& attempt);

}  // namespace impetus::inline store
