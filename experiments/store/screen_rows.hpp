// Before which screens a participant sat.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline store {

/// Kinds of notes of a session: that it resumed on another screen than the one before, and that its
/// pixels really are not square. Both were said by whoever started it.
inline constexpr const char* kScreenChangedNote = "screen changed";
inline constexpr const char* kPixelsNotSquareNote = "pixels not square";

/// The screen of the enrolment's last session; none: there was no session. Throws
/// SQLite::Exception.
std::optional<ScreenGeometry> last_screen(SQLite::Database& database, std::int64_t enrolment_id);

/// A session's screen, and what was said of it.
struct SessionScreen {
  std::int64_t session_id{0};
  std::int64_t enrolment_id{0};
  std::string participant;
  std::string protocol;
  ScreenGeometry screen;
  bool said_changed{false};
  bool said_not_square{false};
};

/// By enrolment, and in the order of time. Throws SQLite::Exception.
std::vector<SessionScreen> session_screens(SQLite::Database& database);

}  // namespace impetus::inline store
