// What must hold between a study's rows though no constraint of a table can say it, and what its
// reader should know.
//
// Each rule is a query that yields one sentence for every violation, so that a rule is read as it
// is checked: order_rules.sql, recording_rules.sql, provenance_rules.sql, and remarks.sql.
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
/// frames, exclusions, words that participants wrote, ...
std::vector<std::string> remarks_on(SQLite::Database& study);

// Whether people saw what was measured: square pixels, and one screen from the first session to the
// last. What was not so, and said, is a remark; what nobody said is wrong.

/// Sessions whose pixels were not square, and resumed ones before another screen than the session
/// before, where nobody said so.
Failures unsaid_screens(SQLite::Database& study);

/// The same that was said; and who sat before several screens.
std::vector<std::string> screen_remarks(SQLite::Database& study);

}  // namespace impetus::inline study
