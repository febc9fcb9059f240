// A JSON file as read: its name for messages, its text for the record, its value for use.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline settings {

/// A JSON file: what it is called, its text, and its value.
struct JsonDocument {
  std::string name;  ///< as messages call it: the path that was given
  std::string text;
  nlohmann::json value;
};

/// Throws InputError: no such file, unreadable, malformed (line and column), a key twice.
JsonDocument read_json(const std::filesystem::path& path);
JsonDocument parse_json(std::string name, std::string text);

/// The JSON Pointer of an element of the list at `list`.
inline std::string item(const std::string& list, std::size_t index) {
  return list + "/" + std::to_string(index);
}

/// "name:/pointer: message".
[[noreturn]] void refuse(const JsonDocument& document, const std::string& pointer,
                         const std::string& message);

}  // namespace impetus::inline settings
