// Which build this is. One source holds the commit, so that a new commit compiles one file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline provenance {

/// "impetus 0.1.0, COMMIT, COMPILER, FLAGS": what a recording names as its build.
const char* build_name();

/// The answer to `impetus --version`: version, commit, compiler with its flags, and which
/// recordings and study files this build can use; a line each.
std::string version_text();

}  // namespace impetus::inline provenance
