// A folder for what is thrown away, gone with its process.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "experiments/power/process_mark.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

/// A folder of this process in another, named `begin` and the process's mark; those of processes of
/// this machine that were killed are removed, and nothing else that begins so.
class ScratchFolder {
 public:
  ScratchFolder(const std::filesystem::path& in, const std::string& begin)
      : folder_(in / (begin + mark_of_this_process())) {
    for (const auto& entry : std::filesystem::directory_iterator(in)) {
      const std::string name = entry.path().filename().string();
      const std::string mark = name.starts_with(begin) ? name.substr(begin.size()) : "";
      if (is_process_mark(mark) && !still_runs(mark)) {
        std::error_code ignored;  // another process may be at it, too
        std::filesystem::remove_all(entry.path(), ignored);
      }
    }
    std::filesystem::create_directories(folder_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// A folder of this machine alone, for what is thrown away. Throws InputError where there is none.
inline std::filesystem::path own_disk() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) {
    throw InputError("TMPDIR: expected a folder of this machine to simulate in, got none");
  }
  return folder;
}

}  // namespace impetus::inline commands
