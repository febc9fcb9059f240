// The file that a command will write once its work is done, looked at before the work begins.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus {

/// Throws InputError, in one sentence that names the file, when it is there already, and
/// std::runtime_error when it could not be written: its folder is missing or closed. Nothing
/// changes.
void require_new_file(const std::filesystem::path& file);

/// The same for a command with the option --force, which replaces what is there.
void require_new_file(const std::filesystem::path& file, bool force);

}  // namespace impetus
