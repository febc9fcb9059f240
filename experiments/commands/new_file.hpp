// The files that a command will write once its work is done, looked at before the work begins.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace impetus::inline commands {

/// Throws InputError, in one sentence that names the file, when it is there already, and
/// std::runtime_error when it could not be written: its folder is missing or closed. Nothing
/// changes. "" is a file that nobody asked for.
void require_new_file(const std::filesystem::path& file);

/// The same for a command with the option --force, which replaces what is there.
void require_new_file(const std::filesystem::path& file, bool force);

/// A file that a command was asked for, and by what: {"--json", "w.json"}.
struct AskedFile {
  std::string asked_by;
  std::filesystem::path file;  ///< "": nobody asked for it
};

/// The same for all files of a command, of which no two may be one.
void require_new_files(const std::vector<AskedFile>& files);

/// The same for pictures, whose names must end as those of PNG files do.
void require_new_pictures(const std::vector<AskedFile>& files);

/// The same for several files of `folder`, the option --out, which may not be there yet. Throws
/// InputError, also when it is a file or could not be made. Nothing changes.
void require_new_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       bool force);

/// Makes the folder of the option --out unless it is there. Throws InputError when it cannot be
/// made.
void make_out_folder(const std::filesystem::path& folder);

}  // namespace impetus::inline commands
