// A study file: one SQLite database, its version, and the lock that keeps two writers apart.
//
// While a session runs the file is in write-ahead mode with full synchronisation; closed properly
// it is one file again, which can be copied, mailed and opened read-only.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

namespace impetus::inline store {

/// The disk or the database failed while something was to be kept. What was acknowledged before
/// is safe.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A study that is open, and locked where it is open for writing.
class StudyFile {
 public:
  /// Opens a study for writing, or makes a new one; `build` goes into a new one. Throws InputError
  /// when the file is no study, of a later version, without one of its tables, read-only, or in use
  /// by another process. A study of an older schema is kept beside it as it was and brought to the
  /// present one.
  static StudyFile open_for_writing(const std::filesystem::path& path, const std::string& build);

  /// Opens a study that exists, read-only; of an older schema, a copy in memory. Throws InputError,
  /// also when one of its tables or views is missing.
  static StudyFile open_for_reading(const std::filesystem::path& path);

  /// The same whatever is missing, for who looks for that.
  static StudyFile open_as_it_is(const std::filesystem::path& path);

  /// A copy in memory, which may be changed: no file is. Throws SQLite::Exception.
  static StudyFile copy_in_memory(StudyFile& study);

  StudyFile(StudyFile&&) noexcept;
  StudyFile& operator=(StudyFile&&) = delete;
  ~StudyFile();

  [[nodiscard]] SQLite::Database& database() { return *database_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// After a commit: that what was written can be found. Throws StoreError when the file was
  /// removed or replaced since it was opened for writing; then all of it is written beside it
  /// first.
  void require_present();

  /// To be held for each transaction and query while several sessions share the file.
  [[nodiscard]] std::mutex& transactions() { return *transactions_; }

 private:
  StudyFile() = default;

  std::string name_;
  int lock_{-1};  ///< closed after the database: closing it earlier would drop SQLite's own locks
  std::unique_ptr<SQLite::Database> database_;
  bool writing_{false};
  std::unique_ptr<std::mutex> transactions_{std::make_unique<std::mutex>()};
};

/// What `action` returns; throws StoreError where SQLite throws.
template <typename Action>
auto while_reading(const StudyFile& study, const Action& action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": could not be read (" + error.what() + ")");
  }
}

}  // namespace impetus::inline store
