// One attempt at a trial as rows of the study file.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>

#include "experiments/record/record.hpp"

namespace impetus::inline store {

/// Whose attempt it is.
struct AttemptOwner {
  std::int64_t trial_id{0};
  std::int64_t session_id{0};
  bool sync_overridden{false};
};

/// How many of its timed frames were late.
std::int64_t late_frames(const AttemptRecord& attempt);

/// Whether a body was taken out in any step of the attempt, for its state was not finite.
bool has_not_finite(const AttemptRecord& attempt);

/// Inserts the attempt with its steps, collisions, frames, gaze, clicks and answers; and for each
/// body that was taken out a note of the session, of kind "not finite", such as "trial 3, attempt
/// 1, step 12: red, linear momentum". Without `keeps_steps` all but the steps. Throws
/// SQLite::Exception.
void insert_attempt(SQLite::Database& database, const AttemptOwner& owner,
                    const AttemptRecord& attempt, bool keeps_steps);

/// Inserts only its collisions, as those of the attempt with this id. Throws SQLite::Exception.
void insert_collisions(SQLite::Database& database, std::int64_t id, const AttemptRecord& attempt);

}  // namespace impetus::inline store
