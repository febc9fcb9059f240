// SPDX-License-Identifier: MIT
#include "experiments/tables/utf8.hpp"

#include <array>

namespace impetus::inline tables {
namespace {

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
