// SPDX-License-Identifier: MIT
#include "experiments/store/study_file.hpp"

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Transaction.h>
#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/migration.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_integrity.hpp"

namespace impetus::inline store {
namespace {

// A study whose file is removed, renamed or replaced while a session writes to it: SQLite goes on
// writing to the file that nobody can find any more, so it is noticed here, and all is kept.

/// Whether `path` still names the file that is open as `descriptor`.
bool is_present(const std::filesystem::path& path, int descriptor) {
  struct stat named {};
  struct stat open {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

/// Writes the whole study to a file that is not there yet: under another name until it is whole, so
/// that no half of it is ever taken for it. Throws SQLite::Exception and filesystem_error.
void copy_to(SQLite::Database& database, const std::filesystem::path& path) {
  const std::string unfinished = path.string() + ".unfinished";
  const auto remove = [&] {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    std::filesystem::remove(unfinished + "-journal", ignored);
  };
  remove();
  try {
    execute(database, "VACUUM INTO ?", plain_name(unfinished));
    std::filesystem::rename(unfinished, path);
  } catch (...) {
    remove();
    throw;
  }
}

/// Writes the whole study beside where it was, as "study.rescued.sqlite" or, where there is such a
/// file, "study.rescued-2.sqlite", ...; returns that path. Throws SQLite::Exception.
std::filesystem::path rescue(SQLite::Database& database, const std::filesystem::path& path) {
  std::filesystem::path rescued = path;
  rescued.replace_extension(".rescued" + path.extension().string());
  for (int number = 2; std::filesystem::exists(rescued); ++number) {
    rescued = path;
    rescued.replace_extension(".rescued-" + std::to_string(number) + path.extension().string());
  }
  copy_to(database, rescued);
  return rescued;
}

/// How long another program, such as a viewer of databases or a backup, may hold the file while a
/// session runs, before the session ends for that.
constexpr int kPatience_ms = 20000;

constexpr int kApplicationId = 0x494d5054;  // "IMPT"

std::int64_t pragma(SQLite::Database& database, const std::string& name) {
  return database.execAndGet("PRAGMA " + name).getInt64();
}

/// Nothing in it yet: new, or left by a process that was killed before the schema was committed.
/// The first read also tells whether it is SQLite.
bool is_empty(SQLite::Database& database, const std::string& name) {
  try {
    return pragma(database, "application_id") == 0 &&
           database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_NOTADB) {
      throw InputError(name + ": expected an Impetus study, got a file that is no SQLite database");
    }
    throw InputError(name + ": expected an Impetus study that can be read: " + error.what());
  }
}

/// ", which BUILD made", where a study of whatever version tells it.
std::string made_by(SQLite::Database& database) {
  try {
    return ", which " + database.execAndGet("SELECT build FROM study").getString() + " made";
  } catch (const SQLite::Exception&) {
    return "";
  }
}

/// Refuses what is not a study of a version that is known; returns that version.
std::int64_t require_study(SQLite::Database& database, const std::string& name) {
  if (is_empty(database, name)) {
    throw InputError(name + ": expected an Impetus study, got an empty file");
  }
  if (pragma(database, "application_id") != kApplicationId) {
    throw InputError(name + ": expected an Impetus study, got a database of another program");
  }
  const std::int64_t version = pragma(database, "user_version");
  if (version < kOldestSchemaVersion || version > kSchemaVersion) {
    throw InputError(name + ": expected a study of schema version " +
                     std::to_string(kOldestSchemaVersion) + " to " +
                     std::to_string(kSchemaVersion) + ", got version " + std::to_string(version) +
                     made_by(database));
  }
  return version;
}

/// The file as it was, beside it: "study.schema-1.sqlite". Throws InputError when something else
/// has that name.
void keep_original(SQLite::Database& database, const std::filesystem::path& path,
                   std::int64_t version) {
  std::filesystem::path kept = path;
  kept.replace_extension(".schema-" + std::to_string(version) + path.extension().string());
  if (std::filesystem::exists(kept)) {
    throw InputError(path.string() + ": expected to keep it, of schema version " +
                     std::to_string(version) + ", as " + kept.string() +
                     " before it is brought to version " + std::to_string(kSchemaVersion) +
                     ", but there is such a file");
  }
  copy_to(database, kept);
  std::fprintf(stderr, "note: %s is of schema version %lld; it is kept as %s and brought to %lld\n",
               path.c_str(), static_cast<long long>(version), kept.c_str(),
               static_cast<long long>(kSchemaVersion));
}

/// Refuses a study of the present schema that lacks one of its tables or views.
void require_tables(SQLite::Database& database, const std::string& name) {
  for (const std::string& difference : schema_differences(database)) {
    if (difference.ends_with(kIsMissing)) {
      throw InputError(name + ": expected a study that is whole, but " + difference);
    }
  }
}

std::unique_ptr<SQLite::Database> copied_in_memory(SQLite::Database& original) {
  auto copy =
      std::make_unique<SQLite::Database>(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Backup(*copy, original).executeStep();
  return copy;
}

void create_schema(SQLite::Database& database, const std::string& build) {
  SQLite::Transaction transaction(database);
  create_tables_and_views(database);
  insert_row(database, "study", {{"id", 1}, {"created_utc", Now()}, {"build", build}});
  database.exec("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.exec("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  transaction.commit();
}

int take_lock(const std::string& name) {
  const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) {
    throw InputError(
        name + ": expected a file that can be written, but it cannot be: " + std::strerror(errno));
  }
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    ::close(file);
    throw InputError(name + ": in use by another Impetus process; end that session first");
  }
  return file;
}

/// While a session runs the log stands beside the study.
void require_writable_folder(const std::filesystem::path& path, const std::string& name) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (::access(folder.c_str(), W_OK) != 0) {
    throw InputError(name +
                     ": expected a folder that can be written, for the study's log beside it, but "
                     "it cannot be: " +
                     std::strerror(errno));
  }
}

}  // namespace

StudyFile StudyFile::open_for_writing(const std::filesystem::path& path, const std::string& build) {
  StudyFile study;
  study.name_ = path.string();
  require_files(path);
  if (std::error_code missing; std::filesystem::file_size(path, missing) == 0 || missing) {
    require_no_strange_log(path);
  }
  study.lock_ = take_lock(study.name_);
  require_writable_folder(path, study.name_);
  try {
    study.database_ = std::make_unique<SQLite::Database>(plain_name(path), SQLite::OPEN_READWRITE);
    study.database_->setBusyTimeout(2000);
    const bool fresh = is_empty(*study.database_, study.name_);
    const std::int64_t version =
        fresh ? kSchemaVersion : require_study(*study.database_, study.name_);
    study.writing_ = true;
    study.database_->exec("PRAGMA foreign_keys = ON");
    study.database_->exec("PRAGMA journal_mode = WAL");
    study.database_->exec("PRAGMA synchronous = FULL");
    if (fresh) {
      create_schema(*study.database_, build);
    } else if (version < kSchemaVersion) {
      keep_original(*study.database_, path, version);
      migrate(*study.database_, version);
    }
    require_tables(*study.database_, study.name_);
    study.database_->setBusyTimeout(kPatience_ms);
  } catch (const SQLite::Exception& error) {
    throw InputError(study.name_ + ": expected a study that can be written: " + error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw InputError(study.name_ + ": expected a study that can be written: " + error.what());
  }
  return study;
}

StudyFile StudyFile::open_for_reading(const std::filesystem::path& path) {
  StudyFile study = open_as_it_is(path);
  try {
    require_tables(*study.database_, study.name_);
  } catch (const SQLite::Exception& error) {
    throw InputError(study.name_ + ": expected an Impetus study that can be read: " + error.what());
  }
  return study;
}

StudyFile StudyFile::open_as_it_is(const std::filesystem::path& path) {
  StudyFile study;
  study.name_ = path.string();
  require_files(path);
  if (std::error_code error; !std::filesystem::exists(path, error)) {
    throw InputError(study.name_ + ": expected an Impetus study, but there is no such file");
  }
  try {
    study.database_ = open_read_only(path);
    const std::int64_t version = require_study(*study.database_, study.name_);
    if (version < kSchemaVersion) {
      study.database_ = copied_in_memory(*study.database_);
      migrate(*study.database_, version);
    }
  } catch (const SQLite::Exception& error) {
    throw InputError(study.name_ + ": expected an Impetus study that can be read: " + error.what());
  }
  return study;
}

void StudyFile::require_present() {
  if (is_present(name_, lock_)) {
    return;
  }
  const std::string gone = name_ + ": removed or replaced while it was written to; ";
  try {
    throw StoreError(gone + "all that was saved is in " + rescue(*database_, name_).string());
  } catch (const SQLite::Exception& error) {
    throw StoreError(gone + "what was saved could not be written beside it: " + error.what());
  }
}

StudyFile StudyFile::copy_in_memory(StudyFile& study) {
  StudyFile copy;
  copy.name_ = study.name();
  copy.database_ = copied_in_memory(*study.database_);
  return copy;
}

StudyFile::StudyFile(StudyFile&& other) noexcept
    : name_(std::move(other.name_)),
      lock_(std::exchange(other.lock_, -1)),
      database_(std::move(other.database_)),
      writing_(other.writing_),
      transactions_(std::move(other.transactions_)) {}

StudyFile::~StudyFile() {
  if (database_ && writing_) {
    // Back to one file. A failure here loses nothing: the log stays beside it and is read next
    // time.
    database_->tryExec("PRAGMA journal_mode = DELETE");
  }
  database_.reset();
  if (lock_ >= 0) {
    ::close(lock_);
  }
}

}  // namespace impetus::inline store
