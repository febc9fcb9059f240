// SPDX-License-Identifier: MIT
#include "experiments/tables/csv_line.hpp"

#include <cmath>

#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline tables {
namespace {

constexpr const char* kHexadecimals = "0123456789abcdef";

std::string quoted_where_needed(const std::string& cell) {
  return cell.find_first_of(",\"\r\n") == std::string::npos ? cell : csv_text(cell);
}

}  // namespace

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += (i == 0 ? "" : ",") + quoted_where_needed(cells[i]);
  }
  return line + "\n";
}

std::string csv_number(double value) {
  if (!std::isfinite(value)) {
    return "";
  }
  constexpr int kDigits = 9;
  return rounded_number(value, kDigits);
}

std::string csv_text(std::string_view text) {
  std::string cell = "\"";
  for (const char letter : text) {
    cell += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return cell + "\"";
}

std::string bits_text(std::int64_t value) {
  std::string text = "x";
  for (int shift = 60; shift >= 0; shift -= 4) {
    text += kHexadecimals[(static_cast<std::uint64_t>(value) >> shift) & 15U];
  }
  return text;
}

std::string bytes_text(std::string_view bytes) {
  std::string text = "x";
  for (const char byte : bytes) {
    const auto value = static_cast<unsigned char>(byte);
    text += kHexadecimals[value >> 4];
    text += kHexadecimals[value & 15U];
  }
  return text;
}

std::string tsv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += (i == 0 ? "" : "\t") + (cells[i].empty() ? "n/a" : cells[i]);
  }
  return line + "\n";
}

std::string tsv_text(std::string_view text) {
  std::string cell = as_utf8(text);
  for (char& letter : cell) {
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F) {
      letter = ' ';
    }
  }
  return cell;
}

}  // namespace impetus::inline tables
