// SPDX-License-Identifier: MIT
#include "experiments/protocol/json_document.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace impetus {
namespace {

using nlohmann::json;

/// "name:3:14: expected ..." for a byte offset, both counted from 1.
std::string place_of(const std::string& text, std::size_t byte) {
  std::size_t line = 1;
  std::size_t column = 0;
  for (std::size_t i = 0; i < byte && i < text.size(); ++i) {
    const bool new_line = text[i] == '\n';
    line += new_line ? 1 : 0;
    column = new_line ? 0 : column + 1;
  }
  return std::to_string(line) + ":" + std::to_string(column);
}

/// Notices a key that stands twice in one object, which the parser would silently let win.
class DuplicateKeys {
 public:
  void see(json::parse_event_t event, const json& parsed) {
    if (event == json::parse_event_t::object_start) {
      open_.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      open_.pop_back();
    } else if (event == json::parse_event_t::key && !open_.back().insert(parsed).second &&
               first_.empty()) {
      first_ = parsed.dump();
    }
  }
  [[nodiscard]] const std::string& first() const { return first_; }

 private:
  std::vector<std::set<json>> open_;
  std::string first_;
};

}  // namespace

JsonDocument parse_json(std::string name, std::string text) {
  DuplicateKeys keys;
  json value;
  try {
    value = json::parse(text, [&keys](int, json::parse_event_t event, json& parsed) {
      keys.see(event, parsed);
      return true;
    });
  } catch (const json::parse_error& error) {
    throw InputError(name + ":" + place_of(text, error.byte) +
                     ": expected valid JSON, got something else here");
  }
  if (!keys.first().empty()) {
    throw InputError(name + ": expected each key once in an object, got " + keys.first() +
                     " twice");
  }
  return {std::move(name), std::move(text), std::move(value)};
}

JsonDocument read_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    const std::string reason = file ? "it is a directory" : std::strerror(errno);
    throw InputError(path.string() + ": expected a JSON file, but it cannot be read: " + reason);
  }
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return parse_json(path.string(), std::move(text));
}

void refuse(const JsonDocument& document, const std::string& pointer, const std::string& message) {
  throw InputError(document.name + ":" + (pointer.empty() ? "/" : pointer) + ": " + message);
}

}  // namespace impetus
