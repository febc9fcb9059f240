// Study files that are only read: beside a running session, on a disk that cannot be written.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>
#include <string>

namespace impetus::inline store {

/// Whether the file is there and not empty.
bool holds_anything(const std::filesystem::path& path);

/// Throws InputError where the study, its log or its journal is something else than a file: a named
/// pipe would be waited for. What is not there is no matter.
void require_files(const std::filesystem::path& path);

/// The file's name as SQLite opens a file by it, though it be called ":memory:" or "file:...".
std::string plain_name(const std::filesystem::path& path);

/// Opens the database for reading. A copy that was left in write-ahead mode without its log, in a
/// folder that cannot be written, is read as what it is: a file that nobody changes. Throws
/// SQLite::Exception, and InputError where a change was left half-written that reading cannot take
/// back.
std::unique_ptr<SQLite::Database> open_read_only(const std::filesystem::path& path);

/// The log of commits that are not in the file yet: "study.sqlite-wal". It belongs to the study.
std::filesystem::path log_beside(const std::filesystem::path& path);

/// Whether such a log stands beside the file and holds anything.
bool has_log(const std::filesystem::path& path);

/// Throws InputError where a log or a half-written change stands beside a file that is to be made.
void require_no_strange_log(const std::filesystem::path& path);

/// Keeps every session away from a study while it is read, for as long as this lives: it must
/// outlive the database that is open on the file, whose own locks it would take along.
class ReadingLock {
 public:
  /// Throws what require_files() throws.
  explicit ReadingLock(const std::filesystem::path& path);
  ~ReadingLock();
  ReadingLock(ReadingLock&& other) noexcept;
  ReadingLock& operator=(ReadingLock&&) = delete;

  /// False: another process writes to the study.
  [[nodiscard]] bool held() const { return held_; }

 private:
  int file_{-1};
  bool held_{false};
};

}  // namespace impetus::inline store
