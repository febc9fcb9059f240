// SPDX-License-Identifier: MIT
#include "experiments/commands/new_file.hpp"

#include <unistd.h>

#include <system_error>

#include "experiments/models/atomic_file.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

void require_none(const std::filesystem::path& file, const char* unless) {
  if (std::filesystem::exists(file)) {
    throw InputError(file.string() + ": exists already and is not overwritten" + unless);
  }
}

/// Whatever folders the two names take their way through.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other) {
  const auto whole = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
  };
  return !one.empty() && !other.empty() && whole(one) == whole(other);
}

/// Whether `folder` can be made, if it is not there, and written to.
bool can_hold_files(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::path there = std::filesystem::absolute(folder, error);
  while (!there.empty() && !std::filesystem::exists(there)) {
    there = there.parent_path();
  }
  return std::filesystem::is_directory(there) && access(there.c_str(), W_OK | X_OK) == 0;
}

}  // namespace

void require_new_file(const std::filesystem::path& file) {
  if (!file.empty()) {
    require_none(file, "");
    require_writable(file);
  }
}

void require_new_file(const std::filesystem::path& file, bool force) {
  if (!force) {
    require_none(file, " without --force");
  }
  require_writable(file);
}

void require_new_files(const std::vector<AskedFile>& files) {
  for (auto one = files.begin(); one != files.end(); ++one) {
    require_new_file(one->file);
    for (auto other = files.begin(); other != one; ++other) {
      if (is_same_file(other->file, one->file)) {
        throw InputError(other->asked_by + " and " + one->asked_by + ": expected two files, got " +
                         one->file.string() + " for both");
      }
    }
  }
}

void require_new_pictures(const std::vector<AskedFile>& files) {
  require_new_files(files);
  for (const AskedFile& each : files) {
    if (!each.file.empty() && each.file.extension() != ".png") {
      throw InputError(each.asked_by + ": expected a picture's name, which ends in .png, got " +
                       each.file.string());
    }
  }
}

void require_new_files(const std::filesystem::path& folder, const std::vector<std::string>& names,
                       bool force) {
  if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder)) {
    throw InputError("--out: expected a folder, but " + folder.string() + " is a file");
  }
  if (!force) {
    for (const std::string& name : names) {
      require_none(folder / name, " without --force");
    }
  }
  if (!can_hold_files(folder)) {
    throw InputError("--out: expected a folder to write to, got " + folder.string());
  }
}

void make_out_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError("--out: expected a folder to write to, could not make " + folder.string());
  }
}

}  // namespace impetus::inline commands
