// SPDX-License-Identifier: MIT
#include "experiments/store/present_file.hpp"

#include <SQLiteCpp/Statement.h>
#include <sys/stat.h>

#include <string>

namespace impetus::inline store {

bool is_present(const std::filesystem::path& path, int descriptor) {
  struct stat named {};
  struct stat open {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &open) == 0 &&
         named.st_dev == open.st_dev && named.st_ino == open.st_ino;
}

std::filesystem::path rescue(SQLite::Database& database, const std::filesystem::path& path) {
  std::filesystem::path rescued = path;
  rescued.replace_extension(".rescued" + path.extension().string());
  for (int number = 2; std::filesystem::exists(rescued); ++number) {
    rescued = path;
    rescued.replace_extension(".rescued-" + std::to_string(number) + path.extension().string());
  }
  SQLite::Statement copy(database, "VACUUM INTO ?");
  copy.bind(1, rescued.string());
  copy.exec();
  return rescued;
}

}  // namespace impetus::inline store
