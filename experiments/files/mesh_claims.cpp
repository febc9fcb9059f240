// SPDX-License-Identifier: MIT
#include "experiments/files/mesh_claims.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/models/readable_file.hpp"

namespace impetus::inline files {
namespace {

// ---------------------------------------------------------------- lines, words and numbers, taken
// from the front of a text

/// Without the line's end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

/// "" at the end.
std::string_view take_word(std::string_view& text) {
  constexpr std::string_view kSpaces = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
  text.remove_prefix(word.size());
  return word;
}

/// Of a word of digits alone; one beyond 64 bits is the greatest there is.
std::optional<std::uint64_t> whole_number(std::string_view word) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) {
    return std::nullopt;
  }
  return error == std::errc::result_out_of_range ? std::numeric_limits<std::uint64_t>::max()
                                                 : number;
}

// ---------------------------------------------------------------- PLY: a header of elements and
// their properties, then a body of so many of each

/// A file of splats has some sixty.
constexpr std::size_t kMostProperties = 1000;

/// A value of each element, or a list of them.
struct Property {
  std::string name;
  std::string length_type;  ///< of a list; "" else
  std::string type;
};

/// What a body holds so many times.
struct Element {
  std::string name;
  std::uint64_t count{0};
  std::vector<Property> properties;
};

/// What stands before the body.
struct Header {
  std::string format;
  std::vector<Element> elements;
};

std::string of_bytes(std::string_view bytes) {
  return ", but the file has " + std::to_string(bytes.size()) + " bytes";
}

Property property_from(std::string_view line) {
  Property property;
  property.type = take_word(line);
  if (property.type == "list") {
    property.length_type = take_word(line);
    property.type = take_word(line);
  }
  property.name = take_word(line);
  return property;
}

/// Leaves `rest` at the body.
Header take_header(std::string_view bytes, std::string_view& rest) {
  Header header;
  std::size_t properties = 0;
  while (!rest.empty()) {
    std::string_view line = take_line(rest);
    const bool may_end = line.starts_with("end_header");
    const std::string_view word = take_word(line);
    if (may_end && word == "end_header" && take_word(line).empty()) {
      return header;
    }
    if (word == "format") {
      header.format = take_word(line);
    } else if (word == "element") {
      const std::string name(take_word(line));
      const std::string_view count = take_word(line);
      header.elements.push_back({name, whole_number(count).value_or(0), {}});
      if (header.elements.back().count > bytes.size()) {
        throw FalseClaim("its PLY header claims " + std::string(count) + " of the element \"" +
                         name + "\"" + of_bytes(bytes));
      }
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_from(line));
      ++properties;
    }
    if (properties + header.elements.size() > kMostProperties) {
      throw FalseClaim("its PLY header has more than " + std::to_string(kMostProperties) +
                       " elements and properties");
    }
  }
  throw FalseClaim("its PLY header has no end");
}

/// Bytes of a value in a binary file; 0 of an unknown type.
std::size_t size_of(const std::string& type) {
  for (const char* one : {"char", "uchar", "int8", "uint8"}) {
    if (type == one) {
      return 1;
    }
  }
  for (const char* two : {"short", "ushort", "int16", "uint16"}) {
    if (type == two) {
      return 2;
    }
  }
  for (const char* four : {"int", "uint", "float", "int32", "uint32", "float32"}) {
    if (type == four) {
      return 4;
    }
  }
  return type == "double" || type == "float64" ? 8 : 0;
}

/// The values of a body, one after another; each answers whether there was one.
class Body {
 public:
  Body(std::string_view bytes, const std::string& format)
      : rest_(bytes), text_(format == "ascii"), big_end_first_(format == "binary_big_endian") {}

  bool skip(const std::string& type, std::uint64_t count) {
    if (!text_) {
      const std::size_t size = size_of(type);
      if (size == 0 || count > rest_.size() / size) {
        return false;
      }
      rest_.remove_prefix(count * size);
      return true;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      if (take_word(rest_).empty()) {
        return false;
      }
    }
    return true;
  }

  /// A list's length; none where the body ends, or what is there is no length.
  std::optional<std::uint64_t> take_length(const std::string& type) {
    if (text_) {
      return whole_number(take_word(rest_));
    }
    const std::size_t size = size_of(type);
    if (size == 0 || size > 4 || size > rest_.size()) {
      return std::nullopt;
    }
    std::uint64_t length = 0;
    for (std::size_t byte = 0; byte < size; ++byte) {
      const std::size_t from = big_end_first_ ? byte : size - 1 - byte;
      length = length << 8U | static_cast<unsigned char>(rest_[from]);
    }
    rest_.remove_prefix(size);
    return length;
  }

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  std::string_view rest_;
  bool text_;
  bool big_end_first_;
};

/// False where the body ends: the reader says so.
bool pass_element(const Element& element, Body& body, std::string_view bytes) {
  for (const Property& property : element.properties) {
    if (property.length_type.empty()) {
      if (!body.skip(property.type, 1)) {
        return false;
      }
      continue;
    }
    const auto length = body.take_length(property.length_type);
    if (!length) {
      return false;
    }
    if (*length > body.left()) {
      throw FalseClaim("a list \"" + property.name + "\" of it claims " + std::to_string(*length) +
                       " values" + of_bytes(bytes));
    }
    if (!body.skip(property.type, *length)) {
      return false;
    }
  }
  return !element.properties.empty();
}

void pass_body(const Header& header, std::string_view body_bytes, std::string_view bytes) {
  Body body(body_bytes, header.format);
  for (const Element& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      if (!pass_element(element, body, bytes)) {
        return;
      }
    }
  }
}

/// Precondition: begins with "ply".
void check_ply(std::string_view bytes) {
  std::string_view rest = bytes;
  take_line(rest);
  const Header header = take_header(bytes, rest);
  const std::string& format = header.format;
  if (!format.empty() && format != "ascii" && format != "binary_little_endian" &&
      format != "binary_big_endian") {
    throw FalseClaim("its PLY header names the format \"" + format +
                     "\", none of ascii, binary_little_endian and binary_big_endian");
  }
  pass_body(header, rest, bytes);
}

// ---------------------------------------------------------------- STL: words, or a count behind 80
// letters and so many triangles

/// Words begin with "solid". An empty file is left to the reader, which says so.
void check_stl(std::string_view bytes) {
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kTriangle = 50;
  std::string_view text = bytes;
  if (bytes.empty() || take_word(text).starts_with("solid")) {
    return;
  }
  if (bytes.size() < kHeader) {
    throw FalseClaim("its STL header takes " + std::to_string(kHeader) + " bytes" +
                     of_bytes(bytes));
  }
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader - sizeof count, sizeof count);
  const std::size_t whole = kHeader + kTriangle * std::size_t{count};
  if (bytes.size() != whole) {
    throw FalseClaim("its STL header claims " + std::to_string(count) +
                     " triangles, with which it has " + std::to_string(whole) + " bytes" +
                     of_bytes(bytes));
  }
}

// ---------------------------------------------------------------- OFF: counts, then lines

/// assimp reads an OFF file into lines of this many letters, and beyond the end of a longer one.
constexpr std::size_t kLongestOffLine = 4095;

void check_lines(std::string_view text) {
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t length = take_line(text).size();
    if (length > kLongestOffLine) {
      throw FalseClaim("its line " + std::to_string(number) + " has " + std::to_string(length) +
                       " letters, more than the " + std::to_string(kLongestOffLine) +
                       " that are read");
    }
  }
}

/// The first two numbers are those of vertices and faces, on the line of "OFF" or after it.
void check_off(std::string_view text) {
  std::string_view rest = text;
  int numbers = 0;
  for (std::string_view line = take_line(rest); numbers < 2; line = take_line(rest)) {
    line = line.substr(0, line.find('#'));
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto count = whole_number(word);
      if (count && ++numbers <= 2 && *count > text.size()) {
        throw FalseClaim("it claims " + std::string(word) +
                         (numbers == 1 ? " vertices" : " faces") + ", but has " +
                         std::to_string(text.size()) + " bytes");
      }
    }
    if (rest.empty()) {
      break;
    }
  }
  check_lines(text);
}

std::string lower_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

void check_claims(const std::filesystem::path& file) {
  const std::string bytes = file_bytes(file);
  const std::string extension = lower_extension(file);
  if (bytes.starts_with("ply")) {
    check_ply(bytes);
  } else if (extension == ".off") {
    check_off(bytes);
  } else if (extension == ".stl") {
    check_stl(bytes);
  } else if (extension == ".gltf" || extension == ".glb" || bytes.starts_with("glTF")) {
    check_gltf(bytes, file.parent_path());
  }
}

}  // namespace

void refuse_false_claims(const std::filesystem::path& file) {
  try {
    check_claims(file);
  } catch (const FalseClaim& claim) {
    throw std::runtime_error(file.string() + ": cannot be read as a mesh: " + claim.what());
  }
}

}  // namespace impetus::inline files
