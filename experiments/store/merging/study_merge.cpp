// SPDX-License-Identifier: MIT
#include "experiments/store/merging/study_merge.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <SQLiteCpp/VariadicBind.h>

#include <deque>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/merging/merge_part.hpp"
#include "experiments/store/merging/row_copy.hpp"

namespace impetus::inline store {
namespace {

bool is_there(const std::filesystem::path& path) {
  std::error_code missing;
  const std::uintmax_t size = std::filesystem::file_size(path, missing);
  return !missing && size > 0;
}

void require_not_a_source(const std::vector<std::filesystem::path>& sources,
                          const std::filesystem::path& into) {
  for (const std::filesystem::path& source : sources) {
    if (is_there(into) && is_there(source) && std::filesystem::equivalent(source, into)) {
      throw InputError("--into " + into.string() +
                       ": expected a study other than those that are merged");
    }
  }
}

/// The sources; before them the destination, if it is there, for as long as they are compared.
std::deque<MergePart> comparable_parts(const std::vector<std::filesystem::path>& sources,
                                       const std::filesystem::path& into) {
  std::deque<MergePart> parts;
  if (is_there(into)) {
    parts.push_back(open_merge_part(into));
  }
  for (const std::filesystem::path& source : sources) {
    parts.push_back(open_merge_part(source));
  }
  require_one_study(parts);
  return parts;
}

/// Participants that came straight from the file's own sessions are the file's; others keep the
/// file that they came from before.
void add_part(MergePart& part, SQLite::Database& destination) {
  const std::int64_t before = copy_rows(part.study.database(), destination);
  SQLite::Statement origin(part.study.database(), "SELECT created_utc, build FROM study");
  origin.executeStep();
  SQLite::Statement file(destination,
                         "INSERT INTO merged_file (name, hash, created_utc, build, merged_utc) "
                         "VALUES (?, ?, ?, ?, strftime('%Y-%m-%dT%H:%M:%fZ'))");
  SQLite::bind(file, std::filesystem::path(part.study.name()).filename().string(), part.hash,
               origin.getColumn(0).getString(), origin.getColumn(1).getString());
  file.exec();
  SQLite::Statement owner(destination,
                          "UPDATE participant SET merged_file_id = ? "
                          "WHERE id > ? AND merged_file_id IS NULL");
  SQLite::bind(owner, destination.getLastInsertRowid(), before);
  owner.exec();
}

std::int64_t count(SQLite::Database& database, const std::string& what) {
  return database.execAndGet("SELECT count(*) FROM " + what).getInt64();
}

MergeResult add_parts(std::deque<MergePart>& parts, StudyFile& study) {
  SQLite::Database& database = study.database();
  const std::int64_t before = count(database, "participant");
  SQLite::Transaction transaction(database);
  for (MergePart& part : parts) {
    add_part(part, database);
  }
  MergeResult result;
  result.participants = count(database, "participant");
  result.participants_added = result.participants - before;
  result.completed_trials = count(database, "attempt WHERE outcome = 'completed'");
  transaction.commit();
  return result;
}

/// A study that was made for a merge which then failed is none.
void remove_study(const std::filesystem::path& path) {
  std::error_code ignored;
  for (const char* ending : {"", "-wal", "-shm"}) {
    std::filesystem::remove(path.string() + ending, ignored);
  }
}

}  // namespace

MergeResult merge_studies(const std::vector<std::filesystem::path>& sources,
                          const std::filesystem::path& into, const std::string& build) {
  require_not_a_source(sources, into);
  std::deque<MergePart> parts = comparable_parts(sources, into);
  const bool is_new = !is_there(into);
  if (!is_new) {
    parts.pop_front();  // its lock goes too: it is opened for writing
  }
  try {
    StudyFile study = StudyFile::open_for_writing(into, build);
    return add_parts(parts, study);
  } catch (const SQLite::Exception& error) {
    if (is_new) {
      remove_study(into);
    }
    throw StoreError(into.string() + ": could not be written (" + error.what() +
                     "); nothing was merged");
  }
}

}  // namespace impetus::inline store
