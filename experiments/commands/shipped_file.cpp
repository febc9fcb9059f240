// SPDX-License-Identifier: MIT
#include "experiments/commands/shipped_file.hpp"

#include <system_error>

namespace impetus::inline commands {

std::string shipped_file(const std::string& given) {
  std::error_code ignored;
  return shipped_file(given, std::filesystem::read_symlink("/proc/self/exe", ignored));
}

std::string shipped_file(const std::string& given, const std::filesystem::path& program) {
  std::error_code ignored;
  const std::filesystem::path name(given);
  if (given.empty() || name.is_absolute() || std::filesystem::exists(name, ignored)) {
    return given;
  }
  const std::filesystem::path place = program.parent_path().parent_path();
  for (const std::filesystem::path& data : {place / "share" / "impetus", place}) {
    if (std::filesystem::is_regular_file(data / "protocols" / "protocol.schema.json", ignored) &&
        std::filesystem::is_regular_file(data / name, ignored)) {
      return (data / name).lexically_normal().string();
    }
  }
  return given;
}

}  // namespace impetus::inline commands
