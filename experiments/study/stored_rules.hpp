// What must hold between a study's rows though no constraint of a table can say it.
//
// Each rule is a query that yields one sentence for every violation, so that a rule is read as it
// is checked. SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include "experiments/study/verification.hpp"

namespace impetus::inline study {

/// Plans are whole, and trials were completed in their order, none passed over. Throws
/// SQLite::Exception, as all here.
Failures broken_order(SQLite::Database& study);

/// Every completed attempt has its steps and frames, as many as were counted, without gaps.
Failures broken_recordings(SQLite::Database& study);

/// Every session says what recorded it, on what, before which screen, and who took part.
Failures broken_provenance(SQLite::Database& study);

}  // namespace impetus::inline study
