// SPDX-License-Identifier: MIT
#include "experiments/tables/text_table.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline tables {
namespace {

bool goes_on(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

std::size_t width_of(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), goes_on));
}

/// Beside ASCII's there are 32 control characters that UTF-8 writes as 0xc2 and 0x80 to 0x9f.
bool is_control(const std::string& text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const bool second_half = at > 0 && static_cast<unsigned char>(text[at - 1]) == 0xc2U;
  return byte < 0x20U || byte == 0x7fU || (second_half && byte >= 0x80U && byte < 0xa0U);
}

}  // namespace

std::string printable(const std::string& text) {
  std::string shown;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (is_control(text, at)) {
      const auto byte = static_cast<unsigned>(static_cast<unsigned char>(text[at]));
      const std::string code = printed("\\x%02x", byte);
      if (byte >= 0x80U) {
        shown.pop_back();  // its first half
      }
      shown += code;
    } else {
      shown += text[at];
    }
  }
  return shown;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> cells = rows;
  std::vector<std::size_t> widths;
  for (std::vector<std::string>& row : cells) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t column = 0; column < row.size(); ++column) {
      row[column] = printable(row[column]);
      widths[column] = std::max(widths[column], width_of(row[column]));
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : cells) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      const bool last = column + 1 == row.size();
      text += row[column];
      text += last ? "\n" : std::string(widths[column] + 2 - width_of(row[column]), ' ');
    }
  }
  return text;
}

std::string two_digits(double value) {
  if (value == 0.0 || !std::isfinite(value)) {
    return value == 0.0 ? "0" : "?";
  }
  const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  const double unit = std::pow(10.0, before_point - 2);
  std::string text =
      printed("%.*f", std::max(0, 2 - before_point), std::round(value / unit) * unit);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
  }
  return text;
}

std::string two_digits_from(double least, double value) {
  return value < least ? "< " + two_digits(least) : two_digits(value);
}

}  // namespace impetus::inline tables
