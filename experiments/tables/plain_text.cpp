// SPDX-License-Identifier: MIT
#include "experiments/tables/plain_text.hpp"

#include <algorithm>

#include "experiments/tables/utf8.hpp"

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

}  // namespace impetus::inline tables
