// A file that another file names: within the folder above the one that holds it, links followed.
//
//   study/protocols/a.json   may name   study/stimuli/b.json   but nothing outside   study/
//
// Who runs a protocol that somebody else wrote opens nothing else of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/settings/json_document.hpp"

namespace impetus::inline settings {

/// The path of the file that `document`, read from `path`, names at `pointer`; `what` it is
/// expected to be stands in messages ("a file"). Throws InputError when the name is absolute, leads
/// out of that folder, or to nothing.
std::filesystem::path named_file(const JsonDocument& document, const std::filesystem::path& path,
                                 const std::string& pointer, const std::string& what);

}  // namespace impetus::inline settings
