// SPDX-License-Identifier: MIT
#include "experiments/models/readable_file.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace impetus::inline models {
namespace {

namespace fs = std::filesystem;

/// What the operating system says, in words that a reader of scenes understands.
std::string system_words(int error) {
  switch (error) {
    case ENOENT:
      return "there is no such file";
    case ENOTDIR:
      return "a part of its path is a file, not a directory";
    case ELOOP:
      return "its links lead round in a circle";
    case ENAMETOOLONG:
      return "its name is too long";
    case EACCES:
    case EPERM:
      return "you have no permission to read it";
    default:
      return std::strerror(error);
  }
}

/// "" of a file.
std::string type_words(fs::file_type type) {
  switch (type) {
    case fs::file_type::regular:
      return "";
    case fs::file_type::directory:
      return "it is a directory, not a file";
    case fs::file_type::fifo:
      return "it is a named pipe, not a file";
    case fs::file_type::socket:
      return "it is a socket, not a file";
    default:
      return "it is a device, not a file";
  }
}

}  // namespace

std::string reading_problem(const fs::path& file, std::uintmax_t most_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (error) {
    return system_words(error.value());
  }
  if (std::string words = type_words(status.type()); !words.empty()) {
    return words;
  }
  if (::access(file.c_str(), R_OK) != 0) {
    return system_words(errno);
  }
  const std::uintmax_t bytes = fs::file_size(file, error);
  return bytes <= most_bytes ? ""
                             : "it has " + std::to_string(bytes) + " bytes, more than the " +
                                   std::to_string(most_bytes) + " that are read";
}

std::string file_bytes(const fs::path& file, std::uintmax_t most_bytes) {
  if (const std::string problem = reading_problem(file, most_bytes); !problem.empty()) {
    throw std::runtime_error(problem);
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(fs::file_size(file)), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (!stream.is_open() || stream.bad()) {
    throw std::runtime_error(system_words(errno));
  }
  return bytes;
}

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
