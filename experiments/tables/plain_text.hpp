// Text of unknown origin, made fit for a file: it is shown as it is and does nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace impetus::inline tables {

/// The text as UTF-8: each byte that is none, and each NUL, becomes U+FFFD.
std::string as_utf8(std::string_view text);

/// Whether a spreadsheet may take the text for a formula: it begins with = + - @, a tab or a
/// carriage return.
bool looks_like_formula(std::string_view text);

/// The text for a page or a table of Markdown, on one line: whatever would be markup is escaped.
std::string markdown_text(std::string_view text);

/// The text as code within a line of Markdown, in a table too.
std::string markdown_code(std::string_view text);

/// For a file's name: ASCII letters and digits stay, all else becomes '-'; at most `longest` bytes.
std::string file_name_text(std::string_view text, std::size_t longest = 64);

/// One character of a text, and how many bytes it takes there.
struct CodePoint {
  std::uint32_t value{0};
  std::size_t bytes{0};
};

/// The code point that a text, which is not empty, begins with; none when it begins with bytes that
/// are no UTF-8: cut short, overlong, half of a pair, or beyond U+10FFFF.
std::optional<CodePoint> first_code_point(std::string_view text);

}  // namespace impetus::inline tables
