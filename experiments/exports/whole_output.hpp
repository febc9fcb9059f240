// What an export writes: files whose failure does not pass unseen; a folder or a file that appears
// whole or not at all.
//
//   files ─> a folder beside it, "NAME.partial-XXXXXX" ─> renamed to NAME (partial_name.hpp)
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "experiments/exports/partial_name.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline exports {

/// A file that is written in parts.
class OutputFile {
 public:
  /// Makes the file, or empties it. Throws StoreError, here and below, naming the file.
  explicit OutputFile(const std::filesystem::path& path);

  void write(std::string_view text);

  /// To be called last: only then is it known that all of it was written.
  void close();

 private:
  void require_good();

  std::filesystem::path path_;
  std::ofstream file_;
};

/// A whole file at once.
void write_output_file(const std::filesystem::path& path, std::string_view text);

/// A file that is put in place once all of it is written.
class WholeFile {
 public:
  /// Makes an empty file beside `target`. Throws InputError when it cannot be made.
  explicit WholeFile(const std::filesystem::path& target);
  ~WholeFile();  ///< removes what was not put in place
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_.path(); }

  /// Once, when all is written, in place of what is there. Throws StoreError when it cannot be
  /// done; then nothing has changed.
  void put_in_place();

 private:
  std::filesystem::path target_;
  PartialName partial_;
};

/// Asked about a target that is a folder of files: throws InputError when that is to stay, as it is
/// wherever it holds what the command did not write (own_files.hpp).
using FolderCheck = std::function<void(const std::filesystem::path&)>;

/// Throws InputError where `target` is a file; where it holds files, what `check` throws.
void require_free_folder(const std::filesystem::path& target, const FolderCheck& check);

/// The folders above a target: those that were not there are made, and are gone again with this
/// while nothing is in them.
class ParentFolders {
 public:
  /// Makes `innermost` and all above it that is missing. Check are_there().
  explicit ParentFolders(const std::filesystem::path& innermost);
  ~ParentFolders();
  ParentFolders(const ParentFolders&) = delete;
  ParentFolders& operator=(const ParentFolders&) = delete;

  [[nodiscard]] bool are_there() const { return are_there_; }

 private:
  void make(const std::filesystem::path& folder);

  std::vector<std::filesystem::path> made_;  ///< the innermost last
  bool are_there_{false};
};

/// A folder that is put in place once all is written.
class WholeFolder {
 public:
  /// `target` must not exist, or be an empty folder, or one that `check` lets be replaced. Throws
  /// InputError otherwise, or when the folder beside it cannot be made.
  WholeFolder(const std::filesystem::path& target, FolderCheck check);
  ~WholeFolder();  ///< removes what was not put in place
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_->path(); }

  /// Once, when all is written. Throws StoreError when it cannot be done, and InputError when the
  /// check refuses what came to be at the target meanwhile; then nothing has changed.
  void put_in_place();

 private:
  std::filesystem::path target_;
  FolderCheck check_;
  ParentFolders parents_;
  std::optional<PartialName> partial_;  ///< none: it is in place
};

/// Refuses a target that exists; with `replace` it may be another study. Throws InputError.
void require_free_file(StudyFile& study, const std::filesystem::path& target, bool replace);

/// Writes the study to `target`. Throws StoreError when it cannot be written; then nothing has
/// changed.
void write_study_copy(StudyFile& study, const std::filesystem::path& target);

}  // namespace impetus::inline exports
