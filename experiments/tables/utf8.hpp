// One code point of UTF-8 after another.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace impetus::inline tables {

struct CodePoint {
  std::uint32_t value{0};
  std::size_t bytes{0};
};

/// The code point that a text, which is not empty, begins with; none when it begins with bytes that
/// are no UTF-8: cut short, overlong, half of a pair, or beyond U+10FFFF.
std::optional<CodePoint> first_code_point(std::string_view text);

}  // namespace impetus::inline tables
