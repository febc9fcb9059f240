// SPDX-License-Identifier: MIT
#include "experiments/store/read_only_file.hpp"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline store {
namespace {

/// What the path is in a URI of SQLite, which takes '?', '#' and '%' for its own.
std::string uri_of(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char letter : path.string()) {
    uri += letter == '?'   ? "%3f"
           : letter == '#' ? "%23"
           : letter == '%' ? "%25"
                           : std::string(1, letter);
  }
  return uri + "?immutable=1";
}

/// SQLite opens a file when it first reads.
void read_something(SQLite::Database& database) {
  database.execAndGet("SELECT count(*) FROM sqlite_master");
}

/// What SQLite keeps beside a file, which it finds beside the file that a link leads to.
std::filesystem::path beside(const std::filesystem::path& path, const char* suffix) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
  return (error ? path : whole).string() + suffix;
}

/// The change that a program which died in it left half-written: "study.sqlite-journal".
std::filesystem::path journal_beside(const std::filesystem::path& path) {
  return beside(path, "-journal");
}

}  // namespace

bool holds_anything(const std::filesystem::path& path) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  return !missing && size > 0;
}

void require_files(const std::filesystem::path& path) {
  for (const std::filesystem::path& file : {path, log_beside(path), journal_beside(path)}) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!error && !std::filesystem::is_regular_file(status)) {
      throw InputError(file.string() +
                       ": expected a file of an Impetus study, got something that is not a file");
    }
  }
}

std::string plain_name(const std::filesystem::path& path) {
  return (path.is_relative() ? "." / path : path).string();
}

std::unique_ptr<SQLite::Database> open_read_only(const std::filesystem::path& path) {
  constexpr int kPatience_ms = 2000;
  auto database = std::make_unique<SQLite::Database>(plain_name(path), SQLite::OPEN_READONLY);
  database->setBusyTimeout(kPatience_ms);
  try {
    read_something(*database);
  } catch (const SQLite::Exception& error) {
    const bool no_place_for_a_log =
        error.getErrorCode() == SQLITE_CANTOPEN || error.getErrorCode() == SQLITE_READONLY;
    if (no_place_for_a_log && holds_anything(journal_beside(path))) {
      throw InputError(path.string() + ": expected a study whose changes are whole, but " +
                       journal_beside(path).string() +
                       " holds one that a program left half-written; `sqlite3 " + path.string() +
                       " .tables`, where the file can be written, takes it back");
    }
    if (no_place_for_a_log && !has_log(path)) {
      return std::make_unique<SQLite::Database>(uri_of(path),
                                                SQLite::OPEN_READONLY | SQLite::OPEN_URI);
    }
  }
  return database;
}

std::filesystem::path log_beside(const std::filesystem::path& path) { return beside(path, "-wal"); }

bool has_log(const std::filesystem::path& path) { return holds_anything(log_beside(path)); }

void require_no_strange_log(const std::filesystem::path& path) {
  for (const std::filesystem::path& left : {log_beside(path), journal_beside(path)}) {
    if (holds_anything(left)) {
      throw InputError(path.string() + ": expected nothing of an earlier study of this name, but " +
                       left.string() +
                       " is there, which would be read as a part of the new one; move it away");
    }
  }
}

ReadingLock::ReadingLock(const std::filesystem::path& path) {
  require_files(path);
  file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  held_ = file_ >= 0 && ::flock(file_, LOCK_SH | LOCK_NB) == 0;
}

ReadingLock::~ReadingLock() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

ReadingLock::ReadingLock(ReadingLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), held_(std::exchange(other.held_, false)) {}

}  // namespace impetus::inline store
