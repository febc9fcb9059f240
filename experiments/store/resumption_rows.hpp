// How a session takes up an enrolment that was left: after which gap, and what it sets aside.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <set>

namespace impetus::inline store {

/// Seconds by the wall clock since anything of the enrolment was last recorded: a trial, a note, a
/// session's start or end. Negative when that clock was set back since; none: there was no session.
/// Throws SQLite::Exception.
std::optional<double> seconds_since_recorded(SQLite::Database& database, std::int64_t enrolment_id);

/// The completed attempts at these slots are no longer: the session `session_id` shows their trials
/// again. All that they recorded stays. Throws SQLite::Exception.
void set_aside(SQLite::Database& database, std::int64_t enrolment_id, std::int64_t session_id,
               const std::set<std::int64_t>& slots);

}  // namespace impetus::inline store
