// SPDX-License-Identifier: MIT
#include "experiments/exports/whole_output.hpp"

#include <SQLiteCpp/Statement.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/read_only_file.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline exports {
namespace {

namespace fs = std::filesystem;

fs::path without_last_slash(const fs::path& path) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(path));
  return whole.has_filename() ? whole : whole.parent_path();
}

fs::path free_target(const fs::path& asked, const FolderCheck& check) {
  fs::path target = without_last_slash(asked);
  require_free_folder(target, check);
  return target;
}

/// What tells people's enrolments in a study from all others, in order.
std::vector<std::string> enrolments_in(StudyFile& study) {
  return load_column<std::string>(
      study.database(),
      "SELECT pseudonym || ', ' || seed || ', ' || planned_utc AS enrolled FROM participant JOIN "
      "enrolment ON participant_id = participant.id ORDER BY enrolled");
}

/// Throws InputError unless the study at `target` can be made again: it was anonymised, or all who
/// took part in it did so in `study`, too.
void require_earlier_copy(StudyFile& study, const fs::path& target) {
  const ReadingLock lock(target);
  if (!lock.held()) {
    throw InputError(target.string() +
                     ": in use by another Impetus process; end that session first");
  }
  StudyFile there = StudyFile::open_for_reading(target);
  const auto anonymised = there.database().execAndGet("SELECT anonymised_by FROM study");
  const std::vector<std::string> theirs = enrolments_in(there);
  const std::vector<std::string> ours = enrolments_in(study);
  if (anonymised.isNull() &&
      !std::includes(ours.begin(), ours.end(), theirs.begin(), theirs.end())) {
    throw InputError(target.string() + ": expected an earlier export of " + study.name() +
                     ", got a study of people whom that has not; it is not overwritten");
  }
}

}  // namespace

void require_free_folder(const fs::path& target, const FolderCheck& check) {
  if (!fs::exists(target)) {
    return;
  }
  if (!fs::is_directory(target)) {
    throw InputError(target.string() + ": expected a folder, got a file");
  }
  if (!fs::is_empty(target)) {
    check(target);
  }
}

OutputFile::OutputFile(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
  require_good();
}

void OutputFile::write(std::string_view text) {
  file_.write(text.data(), static_cast<std::streamsize>(text.size()));
  require_good();
}

void OutputFile::close() {
  file_.close();
  require_good();
}

void OutputFile::require_good() {
  if (!file_.good()) {
    throw StoreError(path_.string() + ": cannot be written");
  }
}

void write_output_file(const std::filesystem::path& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.close();
}

WholeFile::WholeFile(const fs::path& target)
    : target_(target), partial_(target, PartialName::Kind::kFile) {
  if (!partial_.is_made()) {
    throw InputError("--out: expected a file that can be written, could not make " +
                     target.string());
  }
}

WholeFile::~WholeFile() {
  unlink(partial_.path().c_str());
  unlink((partial_.path().string() + "-journal").c_str());  // SQLite's, of a copy that failed
}

void WholeFile::put_in_place() {
  std::error_code error;
  fs::permissions(partial_.path(), fs::perms(0644), error);
  fs::rename(partial_.path(), target_, error);
  if (error) {
    throw StoreError(target_.string() + ": cannot be written (" + error.message() + ")");
  }
}

ParentFolders::ParentFolders(const fs::path& innermost) {
  make(innermost);
  std::error_code error;
  are_there_ = fs::is_directory(innermost, error);
}

ParentFolders::~ParentFolders() {
  std::error_code ignored;
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
    fs::remove(*folder, ignored);  // which leaves a folder alone that holds anything
  }
}

void ParentFolders::make(const fs::path& folder) {
  std::error_code error;
  if (!folder.has_relative_path() || fs::exists(folder, error)) {
    return;
  }
  make(folder.parent_path());
  if (fs::create_directory(folder, error)) {
    made_.push_back(folder);
  }
}

WholeFolder::WholeFolder(const fs::path& target, FolderCheck check)
    : target_(free_target(target, check)),
      check_(std::move(check)),
      parents_(target_.parent_path()) {
  if (parents_.are_there()) {
    partial_.emplace(target_, PartialName::Kind::kFolder);
  }
  if (!partial_ || !partial_->is_made()) {
    throw InputError(target_.string() + ": expected a folder that can be made, but it cannot be");
  }
  std::error_code ignored;
  fs::permissions(path(), fs::perms(0755), ignored);
}

WholeFolder::~WholeFolder() {
  std::error_code ignored;
  if (partial_) {
    fs::remove_all(path(), ignored);
  }
}

void WholeFolder::put_in_place() {
  require_free_folder(target_, check_);  // the work may have taken hours
  std::error_code error;
  std::optional<PartialName> old;  // what a killed program leaves there goes as every other
  if (fs::exists(target_) && !fs::is_empty(target_)) {
    old.emplace(target_, PartialName::Kind::kFolder);
    fs::rename(target_, old->path(), error);
  }
  if (!error) {
    fs::rename(path(), target_, error);
  }
  if (error) {
    std::error_code ignored;
    if (old && !fs::exists(target_)) {
      fs::rename(old->path(), target_, ignored);
    } else if (old) {
      fs::remove(old->path(), ignored);  // empty
    }
    throw StoreError(target_.string() + ": cannot be written (" + error.message() + ")");
  }
  partial_.reset();
  if (old) {
    fs::remove_all(old->path(), error);
  }
}

void require_free_file(StudyFile& study, const fs::path& target, bool replace) {
  const std::string name = target.string();
  require_no_strange_log(target);
  if (!fs::exists(target)) {
    return;
  }
  if (!fs::is_regular_file(target)) {
    throw InputError("--out: expected a file, but " + name + " is a folder");
  }
  if (!replace) {
    throw InputError(name + ": exists already and is not overwritten without --force");
  }
  if (fs::equivalent(study.name(), target)) {
    throw InputError("--out: expected another file than the study itself, got " + name);
  }
  require_earlier_copy(study, target);
}

void write_study_copy(StudyFile& study, const fs::path& target) {
  WholeFile whole(target);
  try {
    execute(study.database(), "VACUUM INTO ?", whole.path().string());
  } catch (const SQLite::Exception& error) {
    throw StoreError(target.string() + ": cannot be written (" + error.what() + ")");
  }
  whole.put_in_place();
}

}  // namespace impetus::inline exports
