// SPDX-License-Identifier: MIT
#include "experiments/models/file_place.hpp"

#include <algorithm>
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

}  // namespace impetus
