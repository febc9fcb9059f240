// The scripts of analysis/ that commands run, as built into the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace impetus::inline exports {

/// Writes the scripts of these names ("report.R") with what all of them share (R/, studies/) to
/// `folder`/analysis; returns that. Throws StoreError when one cannot be written.
std::filesystem::path write_r_scripts(const std::filesystem::path& folder,
                                      const std::set<std::string>& names);

}  // namespace impetus::inline exports
