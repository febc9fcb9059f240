// A folder that appears whole or not at all.
//
//   files ─> a folder beside it, "NAME.partial-XXXXXX" ─> renamed to NAME
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus {

class WholeFolder {
 public:
  /// `target` must not exist, or be an empty folder; with `replace` it may be an earlier export.
  /// Throws InputError otherwise, or when the folder beside it cannot be made.
  WholeFolder(const std::filesystem::path& target, bool replace);
  ~WholeFolder();  ///< removes what was not put in place
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }

  /// Once, when all is written. Throws StoreError when it cannot be done; then nothing has changed.
  void put_in_place();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
};

}  // namespace impetus
