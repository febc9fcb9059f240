// SPDX-License-Identifier: MIT
#include "experiments/exports/output_file.hpp"

#include "experiments/store/study_file.hpp"

namespace impetus::inline exports {

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

}  // namespace impetus::inline exports
