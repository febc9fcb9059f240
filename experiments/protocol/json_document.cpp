// SPDX-License-Identifier: MIT
#include "experiments/protocol/json_document.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace impetus {
namespace {

using nlohmann::json;

/// "3:14": line and column of a byte, both counted from 1; a column is a character.
std::string place_of(const std::string& text, std::size_t byte) {
  std::size_t line = 1;
  std::size_t column = 1;
  for (std::size_t i = 0; i < byte && i < text.size(); ++i) {
    const bool new_line = text[i] == '\n';
    const bool inside_character = (static_cast<unsigned char>(text[i]) & 0xc0U) == 0x80U;
    line += new_line ? 1 : 0;
    column = new_line ? 1 : column + (inside_character ? 0 : 1);
  }
  return std::to_string(line) + ":" + std::to_string(column);
}

/// What stands at a byte, in words.
std::string found_at(const std::string& text, std::size_t byte) {
  if (byte >= text.size()) {
    return "the end of the file";
  }
  const auto first = static_cast<unsigned char>(text[byte]);
  if (first == '\n' || first == '\r') {
    return "the end of the line";
  }
  if (first < ' ') {
    return "a control character";
  }
  const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  return "'" + text.substr(byte, length) + "'";
}

std::string malformed(const std::string& text, const json::parse_error& error) {
  // The parser counts from 1 and stops after the character it could not take.
  const std::size_t byte = error.byte > 0 ? error.byte - 1 : 0;
  const bool encoding = std::string_view(error.what()).find("UTF-8") != std::string_view::npos;
  return place_of(text, byte) + ": expected " +
         (encoding ? "text in UTF-8, got a byte that is not"
                   : "valid JSON, got " + found_at(text, byte));
}

/// More than a screen can hold. What searches texts for patterns calls itself once per letter.
constexpr std::size_t kLongestText = 10'000;

/// The first that a terminal or a screen might do something else with than show it; "": none.
/// U+0080 to U+009F are control characters too.
std::string first_control(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool spaces = byte == '\n' || byte == '\r' || byte == '\t';
    if ((byte < 0x20U && !spaces) || byte == 0x7fU) {
      return text.substr(i, 1);
    }
    if (byte == 0xc2U && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0U) {
      return text.substr(i, 2);
    }
  }
  return "";
}

/// As JSON writes it in ASCII, without the quotes.
std::string escaped(const std::string& text) {
  const std::string quoted = json(text).dump(-1, ' ', true);
  return quoted.substr(1, quoted.size() - 2);
}

/// Follows the parser through the file: knows where it is, and notices what the grammar lets pass
/// (of a key that stands twice the parser would silently take the last).
class Surveyor {
 public:
  void see(json::parse_event_t event, const json& parsed) {
    using Event = json::parse_event_t;
    if (event == Event::value && parsed.is_string()) {
      see_text(parsed.get_ref<const std::string&>());
    }
    if (event == Event::object_start || event == Event::array_start) {
      enter(event == Event::array_start);
    } else if (event == Event::key) {
      see_key(parsed.get<std::string>());
    } else {
      if (event != Event::value) {
        open_.pop_back();
      }
      if (!open_.empty()) {
        ++open_.back().index;
      }
    }
  }

  /// JSON Pointer to the value that comes next.
  [[nodiscard]] std::string place() const {
    json::json_pointer pointer;
    for (const Level& level : open_) {
      level.list ? pointer.push_back(std::to_string(level.index)) : pointer.push_back(level.key);
    }
    return pointer.to_string();
  }

  /// "/pointer: expected ..., got ..."; "" when there is nothing to complain of.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }

 private:
  struct Level {
    bool list{false};
    std::size_t index{0};
    std::string key;
    std::set<std::string> keys;
  };

  void enter(bool list) {
    // What reads the value afterwards calls itself once per level.
    constexpr std::size_t kMostLevels = 64;
    if (open_.size() == kMostLevels) {
      complain("expected at most " + std::to_string(kMostLevels) + " levels of nesting, got more");
    }
    open_.push_back({list, 0, "", {}});
  }

  void see_text(const std::string& text) {
    if (text.size() > kLongestText && !is_content()) {
      complain("expected at most " + std::to_string(kLongestText) + " bytes of text, got " +
               std::to_string(text.size()));
    } else if (const std::string control = first_control(text); !control.empty()) {
      complain("expected text without control characters but line breaks and tabs, got " +
               escaped(control));
    }
  }

  /// Of a mesh that a stored scene holds (scenes/scene_meshes.hpp): nobody's words.
  [[nodiscard]] bool is_content() const { return !open_.empty() && open_.back().key == "base64"; }

  void see_key(std::string key) {
    open_.back().key = key.size() > kLongestText ? "a key" : escaped(key);
    see_text(key);
    open_.back().key = key;
    if (!open_.back().keys.insert(std::move(key)).second) {
      complain("expected each key once, got it twice");
    }
  }

  void complain(const std::string& message) {
    if (complaint_.empty()) {
      complaint_ = place() + ": " + message;
    }
  }

  std::vector<Level> open_;
  std::string complaint_;
};

/// "1e400" from the parser's "... overflow parsing '1e400'".
std::string between_quotes(const std::string& message) {
  const std::size_t first = message.find('\'') + 1;
  return message.substr(first, message.rfind('\'') - first);
}

}  // namespace

JsonDocument parse_json(std::string name, std::string text) {
  Surveyor surveyor;
  json value;
  try {
    value = json::parse(text, [&surveyor](int, json::parse_event_t event, json& parsed) {
      surveyor.see(event, parsed);
      return true;
    });
  } catch (const json::parse_error& error) {
    throw InputError(name + ":" + malformed(text, error));
  } catch (const json::out_of_range& error) {
    throw InputError(name + ":" + surveyor.place() +
                     ": expected a number of at most 1.8e308, got " + between_quotes(error.what()));
  }
  if (!surveyor.complaint().empty()) {
    throw InputError(name + ":" + surveyor.complaint());
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
