// A folder that appears whole or not at all.
//
//   files ─> a folder beside it, "NAME.partial-XXXXXX" ─> renamed to NAME
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

namespace impetus::inline exports {

/// Asked about a target that is a folder of files: throws InputError when that is to stay.
using FolderCheck = std::function<void(const std::filesystem::path&)>;

class WholeFolder {
 public:
  /// `target` must not exist, or be an empty folder; with `replace` it may be an earlier export.
  /// Throws InputError otherwise, or when the folder beside it cannot be made.
  WholeFolder(const std::filesystem::path& target, bool replace);
  /// A target that holds files is replaced when `check` lets it be.
  WholeFolder(const std::filesystem::path& target, const FolderCheck& check);
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

}  // namespace impetus::inline exports
