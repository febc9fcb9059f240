// A file that is written in parts, and a failure that does not pass unseen.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace impetus::inline exports {

class OutputFile {
 public:
  /// Makes the file, or empties it. Throws StoreError, here and below, naming the file.
  explicit OutputFile(const std::filesystem::path& path);

  void write(std::string_view text);

  /// To be called last: only then is it known that all of it was written.
  void close();

 private:
  void require_good();

  std::filesystem::path path_;
  std::ofstream file_;
};

/// A whole file at once.
void write_output_file(const std::filesystem::path& path, std::string_view text);

}  // namespace impetus::inline exports
