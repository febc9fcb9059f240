// SPDX-License-Identifier: MIT
#include "experiments/exports/partial_name.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
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

/// A journal of SQLite's goes with its file, or after it; everything else when nobody holds it.
bool can_go(const fs::path& path) {
  const std::string name = path.string();
  std::error_code error;
  return name.ends_with(kJournal)
             ? !fs::exists(name.substr(0, name.size() - kJournal.size()), error)
             : is_left_behind(path);
}

void remove_what_was_left(const fs::path& target) {
  const std::string begin = target.filename().string() + std::string(kMark);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(
           target.has_parent_path() ? target.parent_path() : fs::path("."), ignored)) {
    const std::string name = entry.path().filename().string();
    const std::string end = name.starts_with(begin)
                                ? name.substr(std::min(name.size(), begin.size() + kLetters))
                                : name;
    if (name.size() >= begin.size() + kLetters && (end.empty() || end == kJournal) &&
        can_go(entry.path())) {
      fs::remove_all(entry.path(), ignored);
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
