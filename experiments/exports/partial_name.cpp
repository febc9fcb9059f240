// SPDX-License-Identifier: MIT
#include "experiments/exports/partial_name.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <system_error>

namespace impetus::inline exports {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".partial-";
constexpr std::string_view kJournal = "-journal";
constexpr std::size_t kLetters = 6;

OpenFile opened(const fs::path& path) { return OpenFile(open(path.c_str(), O_RDONLY | O_CLOEXEC)); }

/// Whether nobody holds it; and nobody is just about to, as in the moment after it was made.
bool is_left_behind(const fs::path& path) {
  std::error_code error;
  const auto changed = fs::last_write_time(path, error);
  if (error || fs::file_time_type::clock::now() - changed < std::chrono::seconds(2)) {
    return false;
  }
  const OpenFile file = opened(path);
  return file.is_open() && flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

void remove_what_was_left(const fs::path& target) {
  const std::string begin = target.filename().string() + std::string(kMark);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(
           target.has_parent_path() ? target.parent_path() : fs::path("."), ignored)) {
    std::string name = entry.path().filename().string();
    fs::path of = entry.path();
    if (name.ends_with(kJournal)) {  // a journal goes with its file, or after it
      name.resize(name.size() - kJournal.size());
      of.replace_filename(name);
      if (fs::exists(of, ignored)) {
        continue;
      }
      of = entry.path();
    }
    if (name.size() == begin.size() + kLetters && name.starts_with(begin) && is_left_behind(of)) {
      fs::remove_all(of, ignored);
    }
  }
}

}  // namespace

PartialName::PartialName(const fs::path& target, Kind kind) {
  remove_what_was_left(target);
  std::string pattern = target.string() + std::string(kMark) + std::string(kLetters, 'X');
  if (kind == Kind::kFile) {
    lock_ = OpenFile(mkostemp(pattern.data(), O_CLOEXEC));
  } else if (mkdtemp(pattern.data()) != nullptr) {
    lock_ = opened(pattern);
  }
  if (lock_.is_open()) {
    static_cast<void>(flock(lock_.get(), LOCK_EX | LOCK_NB));  // where there are none, it is old
    path_ = pattern;
  }
}

}  // namespace impetus::inline exports
