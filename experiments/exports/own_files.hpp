// Which files of a folder are a command's own: a folder that holds others is never replaced.
//
//   "report.html", "data/study.csv", "figures/"   files, and folders that hold nothing, each by its
//                                                 name from the folder on
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>

namespace impetus::inline exports {

/// What is below `folder`, links as such. Throws InputError when it cannot be read.
std::set<std::string> names_below(const std::filesystem::path& folder);

/// Whether a command writes files of this name.
using OwnName = std::function<bool(const std::string& name)>;

/// The first name below `folder` that is not own; "" where all are. Throws InputError when the
/// folder cannot be read.
std::string foreign_name(const std::filesystem::path& folder, const OwnName& is_own);

}  // namespace impetus::inline exports
