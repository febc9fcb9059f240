// A study without the people: what could tell who took part is taken out, what was measured stays.
//
//   codes            new, in random order, and the numbers of all rows in that order
//   typed            answers outside trials, free text, reasons of exclusions, texts of notes
//   machine          its name; what was merged
//   wall clock       days since each participant's own first, from 2000-01-01
//   clock of frames  each sitting's begins at one second: differences stay
//
// Trials replay as ever: their conditions and seeds stay. A seed follows from the code given at
// enrolment, so whoever can guess that code can check the guess.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <functional>
#include <string>

namespace impetus::inline exports {

/// The hash of a protocol, from its own text and its scene's.
using ProtocolHash = std::function<std::string(const std::string&, const std::string&)>;

/// Changes the study for good: work on a copy. `build` is written down as what did it. What the
/// database held before may still lie in its free pages: VACUUM it into the file to hand out.
/// Throws StoreError or SQLite::Exception; then nothing has changed.
void anonymise(SQLite::Database& study, const std::string& build, const ProtocolHash& hash);

}  // namespace impetus::inline exports
