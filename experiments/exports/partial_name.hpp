// What is written beside its target until it is whole, under "NAME.partial-XXXXXX".
//
// Whoever writes holds a lock on it, which the system takes away when the program ends, however it
// ends: what nobody holds was left by a killed one, and the next to write the same target removes
// it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/connections/open_file.hpp"

namespace impetus::inline exports {

/// A new file or folder beside a target, locked.
class PartialName {
 public:
  /// What is written.
  enum class Kind { kFile, kFolder };

  /// Removes what killed programs left of the target, and makes another. Check is_made().
  PartialName(const std::filesystem::path& target, Kind kind);

  [[nodiscard]] bool is_made() const { return !path_.empty(); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  OpenFile lock_;
};

}  // namespace impetus::inline exports
