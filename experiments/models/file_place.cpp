// SPDX-License-Identifier: MIT
#include "experiments/models/file_place.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <system_error>

namespace impetus::inline models {

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

std::string decoded_uri(const std::string& uri) {
  const auto is_hexadecimal = [&](std::size_t place) {
    return place < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[place])) != 0;
  };
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && is_hexadecimal(i + 1) && is_hexadecimal(i + 2);
    path += escape ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    i += escape ? 2 : 0;
  }
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(file, error);
}

std::string problem_of_place(const std::string& file, const fs::path& folder,
                             const std::string& whose) {
  const fs::path path = file;
  const std::string name =
      nlohmann::json(file).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end()) {
    return "expected a path within the " + whose + "'s folder, got " + name;
  }
  const fs::path own = folder.empty() ? "." : folder;
  if (is_there(own / path) && !is_really_within(own / path, own)) {
    return "expected a file within the " + whose + "'s folder, got " + name +
           ", which is a link out of it";
  }
  return "";
}

}  // namespace impetus::inline models
