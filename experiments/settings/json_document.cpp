// SPDX-License-Identifier: MIT
#include "experiments/settings/json_document.hpp"

#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/models/readable_file.hpp"

namespace impetus::inline settings {
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

/// A scene that holds its meshes is the largest; what has more values would be judged for minutes.
constexpr std::uintmax_t kMostJsonBytes = 500'000'000;
constexpr std::size_t kMostValues = 1'000'000;

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

/// Goes through a file before it is read: knows where it is, and refuses what the grammar lets pass
/// (of a key that stands twice the parser would silently take the last). Nothing is kept, and what
/// is refused throws InputError, so that the rest is not looked at.
class Surveyor final : public json::json_sax_t {
 public:
  explicit Surveyor(const std::string& name) : name_(name) {}

  bool null() override { return see_value(); }
  bool boolean(bool /*value*/) override { return see_value(); }
  bool number_integer(std::int64_t /*value*/) override { return see_value(); }
  bool number_unsigned(std::uint64_t /*value*/) override { return see_value(); }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return see_value(); }
  bool binary(json::binary_t& /*value*/) override { return see_value(); }
  bool string(std::string& text) override {
    see_text(text);
    return see_value();
  }
  bool key(std::string& text) override {
    see_key(text);
    return true;
  }
  bool start_object(std::size_t /*size*/) override { return enter(/*list=*/false); }
  bool start_array(std::size_t /*size*/) override { return enter(/*list=*/true); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  /// json::parse() says it again.
  bool parse_error(std::size_t /*byte*/, const std::string& /*token*/,
                   const json::exception& /*error*/) override {
    return false;
  }

  /// JSON Pointer to the value that comes next.
  [[nodiscard]] std::string place() const {
    json::json_pointer pointer;
    for (const Level& level : open_) {
      level.list ? pointer.push_back(std::to_string(level.index)) : pointer.push_back(level.key);
    }
    return pointer.to_string();
  }

 private:
  /// A list or object that is being read, and how far.
  struct Level {
    bool list{false};
    std::size_t index{0};
    std::string key;
    std::set<std::string> keys;
  };

  void count_value() {
    if (++values_ > kMostValues) {
      complain("expected at most " + std::to_string(kMostValues) + " values in a file, got more");
    }
  }

  bool see_value() {
    count_value();
    pass_value();
    return true;
  }

  void pass_value() {
    if (!open_.empty()) {
      ++open_.back().index;
    }
  }

  bool enter(bool list) {
    // What reads the value afterwards calls itself once per level.
    constexpr std::size_t kMostLevels = 64;
    count_value();
    if (open_.size() == kMostLevels) {
      complain("expected at most " + std::to_string(kMostLevels) + " levels of nesting, got more");
    }
    open_.push_back({list, 0, "", {}});
    return true;
  }

  bool leave() {
    open_.pop_back();
    pass_value();
    return true;
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

  [[noreturn]] void complain(const std::string& message) const {
    throw InputError(name_ + ":" + place() + ": " + message);
  }

  const std::string& name_;
  std::vector<Level> open_;
  std::size_t values_{0};
};

/// "1e400" from the parser's "... overflow parsing '1e400'".
std::string between_quotes(const std::string& message) {
  const std::size_t first = message.find('\'') + 1;
  return message.substr(first, message.rfind('\'') - first);
}

}  // namespace

JsonDocument parse_json(std::string name, std::string text) {
  Surveyor surveyor(name);
  json value;
  try {
    json::sax_parse(text, &surveyor);
    value = json::parse(text);
  } catch (const json::parse_error& error) {
    throw InputError(name + ":" + malformed(text, error));
  } catch (const json::out_of_range& error) {
    throw InputError(name + ":" + surveyor.place() +
                     ": expected a number of at most 1.8e308, got " + between_quotes(error.what()));
  }
  return {std::move(name), std::move(text), std::move(value)};
}

JsonDocument read_json(const std::filesystem::path& path) {
  std::string text;
  try {
    text = file_bytes(path, kMostJsonBytes);
  } catch (const std::runtime_error& error) {
    throw InputError(path.string() +
                     ": expected a JSON file, but it cannot be read: " + error.what());
  }
  return parse_json(path.string(), std::move(text));
}

void refuse(const JsonDocument& document, const std::string& pointer, const std::string& message) {
  throw InputError(document.name + ":" + (pointer.empty() ? "/" : pointer) + ": " + message);
}

}  // namespace impetus::inline settings
