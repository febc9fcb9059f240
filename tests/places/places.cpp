// SPDX-License-Identifier: MIT
#include "tests/places/places.hpp"

namespace impetus {

std::string source_folder() { return IMPETUS_SOURCE_DIR; }

std::string program_file() { return IMPETUS_PROGRAM; }

}  // namespace impetus
