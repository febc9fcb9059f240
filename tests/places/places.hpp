// Where the sources and the built program are. Compiled once and apart: all other tests are the
// same bytes in every checkout, so that a compiler cache serves them all.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus {

/// The project's root, without a slash at the end.
std::string source_folder();

/// The built `impetus`.
std::string program_file();

}  // namespace impetus
