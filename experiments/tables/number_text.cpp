// SPDX-License-Identifier: MIT
#include "experiments/tables/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace impetus::inline tables {
namespace {

constexpr int kMostDigits = 17;  // that any double needs

}  // namespace

std::string count_of(std::int64_t count, const std::string& one, const std::string& many) {
  const std::string& others = many.empty() ? one + "s" : many;
  return std::to_string(count) + " " + (count == 1 ? one : others);
}

std::string printed(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::va_list again;
  va_copy(again, values);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  va_end(values);
  return text;
}

std::string exact_number_by_trial(double value) {
  if (!std::isfinite(value)) {
    return printed("%g", value);
  }
  int decimals = 0;  // behind the first digit
  std::string text = printed("%.*e", decimals, value);
  while (std::strtod(text.c_str(), nullptr) != value && decimals + 1 < kMostDigits) {
    text = printed("%.*e", ++decimals, value);
  }
  const int exponent = std::atoi(text.c_str() + text.find('e') + 1);
  const int behind_point = decimals > exponent ? decimals - exponent : 0;
  const std::string plain = printed("%.*f", behind_point, value);
  return plain.size() <= text.size() ? plain : text;
}

#ifdef __cpp_lib_to_chars
std::string exact_number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string rounded_number(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}
#else
std::string exact_number(double value) { return exact_number_by_trial(value); }

std::string rounded_number(double value, int digits) { return printed("%.*g", digits, value); }
#endif

}  // namespace impetus::inline tables
