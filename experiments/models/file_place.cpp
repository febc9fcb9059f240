// SPDX-License-Identifier: MIT
#include "experiments/models/file_place.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

namespace impetus {

namespace fs = std::filesystem;

bool is_named_within(const fs::path& file, const fs::path& folder) {
  const fs::path whole = file.lexically_normal();
  const fs::path outer = folder.lexically_normal();
  const auto last = outer.has_filename() ? outer.end() : std::prev(outer.end());
  return std::mismatch(outer.begin(), last, whole.begin(), whole.end()).first == last;
}

bool is_really_within(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(file, error);
  if (error) {
    return false;
  }
  const fs::path outer = fs::canonical(folder, error);
  return !error && is_named_within(whole, outer);
}

std::string problem_of_place(const std::string& file, const fs::path& folder) {
  const fs::path path = file;
  const std::string name = nlohmann::json(file).dump();
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
    return "expected a path within the scene's folder, got " + name;
  }
  const fs::path own = folder.empty() ? "." : folder;
  if (fs::exists(own / path) && !is_really_within(own / path, own)) {
    return "expected a file within the scene's folder, got " + name + ", which is a link out of it";
  }
  return "";
}

}  // namespace impetus
