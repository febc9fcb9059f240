// Whether people saw what was measured: square pixels, and one screen from the first session to the
// last. What was not so, and said, is a remark; what nobody said is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// Sessions whose pixels were not square, and resumed ones before another screen than the session
/// before, where nobody said so. Throws SQLite::Exception.
Failures unsaid_screens(SQLite::Database& study);

/// The same that was said; and who sat before several screens. Throws SQLite::Exception.
std::vector<std::string> screen_remarks(SQLite::Database& study);

}  // namespace impetus::inline study
