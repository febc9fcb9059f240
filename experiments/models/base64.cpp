// SPDX-License-Identifier: MIT
#include "experiments/models/base64.hpp"

#include <cstdint>
#include <stdexcept>

namespace impetus::inline models {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr char kFiller = '=';

std::uint32_t value_of(char letter) {
  const std::size_t value = kLetters.find(letter);
  if (value == std::string_view::npos) {
    throw std::runtime_error("expected base64, got a letter that has no place in it");
  }
  return static_cast<std::uint32_t>(value);
}

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t start = 0; start < bytes.size(); start += 3) {
    const std::string_view group = bytes.substr(start, 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      bits = bits << 8U | (i < group.size() ? static_cast<unsigned char>(group[i]) : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= group.size() ? kLetters[bits >> (18 - 6 * i) & 63U] : kFiller;
    }
  }
  return text;
}

std::string bytes_from_base64(std::string_view text) {
  if (text.size() % 4 != 0) {
    throw std::runtime_error("expected base64 in groups of four letters, got " +
                             std::to_string(text.size()) + " letters");
  }
  const bool one_filler = text.ends_with(kFiller);
  const std::size_t fillers = text.ends_with("==") ? 2 : one_filler ? 1 : 0;
  text.remove_suffix(fillers);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  for (std::size_t start = 0; start < text.size(); start += 4) {
    const std::string_view group = text.substr(start, 4);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      bits = bits << 6U | (i < group.size() ? value_of(group[i]) : 0U);
    }
    for (std::size_t i = 0; i + 1 < group.size(); ++i) {
      bytes += static_cast<char>(static_cast<unsigned char>(bits >> (16 - 8 * i)));
    }
  }
  return bytes;
}

}  // namespace impetus::inline models
