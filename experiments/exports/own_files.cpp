// SPDX-License-Identifier: MIT
#include "experiments/exports/own_files.hpp"

#include <algorithm>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline exports {

namespace fs = std::filesystem;

std::set<std::string> names_below(const fs::path& folder) {
  std::set<std::string> names;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const std::string name = entry.path().lexically_relative(folder).string();
      if (!fs::is_directory(entry.symlink_status())) {
        names.insert(name);
      } else if (fs::is_empty(entry.path())) {
        names.insert(name + "/");
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string() + ": cannot be looked through (" + error.code().message() +
                     ")");
  }
  return names;
}

std::string foreign_name(const fs::path& folder, const OwnName& is_own) {
  const std::set<std::string> names = names_below(folder);
  const auto foreign = std::find_if_not(names.begin(), names.end(), is_own);
  return foreign == names.end() ? "" : *foreign;
}

}  // namespace impetus::inline exports
