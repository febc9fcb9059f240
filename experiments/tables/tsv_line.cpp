// SPDX-License-Identifier: MIT
#include "experiments/tables/tsv_line.hpp"

#include "experiments/tables/plain_text.hpp"

namespace impetus::inline tables {

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
