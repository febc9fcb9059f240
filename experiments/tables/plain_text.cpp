// SPDX-License-Identifier: MIT
#include "experiments/tables/plain_text.hpp"

#include <algorithm>
#include <array>

namespace impetus::inline tables {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

bool is_ascii_word(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9');
}

/// Where an underscore is no markup.
bool is_within_word(std::string_view text, std::size_t place) {
  return place > 0 && place + 1 < text.size() && is_ascii_word(text[place - 1]) &&
         is_ascii_word(text[place + 1]);
}

/// A form of UTF-8: its first byte, and the least code point that may take it.
struct Form {
  std::uint8_t mask;
  std::uint8_t lead;
  std::uint32_t least;
};

/// By how many bytes follow the first.
constexpr std::array<Form, 4> kForms{
    {{0x80, 0x00, 0}, {0xE0, 0xC0, 0x80}, {0xF0, 0xE0, 0x800}, {0xF8, 0xF0, 0x10000}}};

bool is_scalar(std::uint32_t code) {
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code <= 0x10FFFF && !surrogate;
}

}  // namespace

std::string as_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto point = first_code_point(text);
    const bool stays = point && point->value != 0;
    result += stays ? text.substr(0, point->bytes) : std::string_view(kReplacement);
    text.remove_prefix(stays ? point->bytes : 1);
  }
  return result;
}

bool looks_like_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos;
}

std::string markdown_text(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (letter == '\n' || letter == '\r' || letter == '\t') {
      result += ' ';
    } else if (letter == '<') {
      result += "&lt;";
    } else if (letter == '>') {
      result += "&gt;";
    } else if (letter == '&') {
      result += "&amp;";
    } else if (std::string_view("\\`*[]|#~").find(letter) != std::string_view::npos ||
               (letter == '_' && !is_within_word(text, i))) {
      result += std::string("\\") + letter;
    } else {
      result += letter;
    }
  }
  return result;
}

std::string markdown_code(std::string_view text) {
  std::string inside;
  std::size_t run = 0;
  std::size_t longest = 0;
  for (const char letter : text) {
    run = letter == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
    const bool breaks = letter == '\n' || letter == '\r';
    inside += breaks ? " " : letter == '|' ? "\\|" : std::string(1, letter);
  }
  const std::string fence(longest + 1, '`');
  const std::string space = longest > 0 ? " " : "";
  return fence + space + inside + space + fence;
}

std::string file_name_text(std::string_view text, std::size_t longest) {
  std::string result;
  for (const char letter : text.substr(0, longest)) {
    result += is_ascii_word(letter) ? letter : '-';
  }
  return result;
}

std::optional<CodePoint> first_code_point(std::string_view text) {
  const auto first = static_cast<std::uint8_t>(text[0]);
  std::size_t following = 0;
  while (following < kForms.size() && (first & kForms[following].mask) != kForms[following].lead) {
    ++following;
  }
  if (following == kForms.size() || text.size() <= following) {
    return std::nullopt;
  }
  std::uint32_t code = first & static_cast<std::uint8_t>(~kForms[following].mask);
  for (std::size_t i = 1; i <= following; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if ((byte & 0xC0U) != 0x80U) {
      return std::nullopt;
    }
    code = (code << 6U) | (byte & 0x3FU);
  }
  if (code < kForms[following].least || !is_scalar(code)) {
    return std::nullopt;
  }
  return CodePoint{code, following + 1};
}

}  // namespace impetus::inline tables
