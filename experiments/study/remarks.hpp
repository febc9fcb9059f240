// What a reader of a published study should know of it, and forbids nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

namespace impetus::inline study {

/// One sentence each: simulated participants, what is not finished, overridden sync tests, late
/// frames, exclusions, words that participants wrote, ... Throws SQLite::Exception.
std::vector<std::string> remarks_on(SQLite::Database& study);

}  // namespace impetus::inline study
