// SPDX-License-Identifier: MIT
#include "experiments/exports/study_copy.hpp"

#include <SQLiteCpp/Statement.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline exports {
namespace {

namespace fs = std::filesystem;

/// A file beside another, empty, and removed again unless it was put in its place.
class FileBeside {
 public:
  explicit FileBeside(const fs::path& target) : target_(target) {
    name_ = target.string() + ".partial-XXXXXX";
    const int file = mkstemp(name_.data());
    if (file < 0) {
      throw InputError("--out: expected a file that can be written, could not make " +
                       target.string());
    }
    close(file);
  }
  ~FileBeside() { unlink(name_.c_str()); }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

  void put_in_place() {
    std::error_code error;
    fs::permissions(name_, fs::perms(0644), error);
    fs::rename(name_, target_, error);
    if (error) {
      throw StoreError(target_.string() + ": cannot be written (" + error.message() + ")");
    }
  }

 private:
  fs::path target_;
  std::string name_;
};

}  // namespace

void require_free_file(const StudyFile& study, const fs::path& target, bool replace) {
  const std::string name = target.string();
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
  static_cast<void>(StudyFile::open_for_reading(target));  // a study: nothing else is overwritten
}

void write_study_copy(StudyFile& study, const fs::path& target) {
  FileBeside beside(target);
  try {
    SQLite::Statement copy(study.database(), "VACUUM INTO ?");
    copy.bind(1, beside.name());
    copy.exec();
  } catch (const SQLite::Exception& error) {
    throw StoreError(target.string() + ": cannot be written (" + error.what() + ")");
  }
  beside.put_in_place();
}

}  // namespace impetus::inline exports
