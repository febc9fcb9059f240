// What must hold between a study's rows though no constraint of a table can say it.
//
// Each rule is a query that yields one sentence for every violation, so that a rule is read as it
// is checked.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// Plans are whole, and trials were completed in their order, none passed over. Throws
/// SQLite::Exception, as all here.
Failures broken_order(SQLite::Database& study);

/// Every completed attempt has its steps and frames, as many as were counted, without gaps.
Failures broken_recordings(SQLite::Database& study);

/// Every session says what recorded it, on what, before which screen, and who took part.
Failures broken_provenance(SQLite::Database& study);

/// One sentence each: simulated participants, what is not finished, overridden sync tests, late
/// frames, exclusions, words that participants wrote, ... Throws SQLite::Exception.
std::vector<std::string> remarks_on(SQLite::Database& study);

/// Sessions whose pixels were not square, and resumed ones before another screen than the session
/// before, where nobody said so. Throws SQLite::Exception.
Failures unsaid_screens(SQLite::Database& study);

/// The same that was said; and who sat before several screens. Throws SQLite::Exception.
std::vector<std::string> screen_remarks(SQLite::Database& study);

}  // namespace impetus::inline study
