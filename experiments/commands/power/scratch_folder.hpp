// A folder for what is thrown away, gone with its process.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "experiments/power/process_mark.hpp"

namespace impetus::inline commands {

/// A folder of this process in another, named `begin` and the process's mark; those of processes of
/// this machine that were killed are removed.
class ScratchFolder {
 public:
  ScratchFolder(const std::filesystem::path& in, const std::string& begin)
      : folder_(in / (begin + mark_of_this_process())) {
    for (const auto& entry : std::filesystem::directory_iterator(in)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(begin) && !still_runs(name.substr(begin.size()))) {
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

}  // namespace impetus::inline commands
