// Reads CSV back, by RFC 4180 alone; it shares nothing with what writes it.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace impetus {

struct CsvCell {
  std::string text;
  bool quoted{false};
};

struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<CsvCell>> rows;

  [[nodiscard]] const CsvCell& at(std::size_t row, const std::string& name) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) {
        return rows.at(row).at(i);
      }
    }
    static const CsvCell kNone{"no such column", false};
    ADD_FAILURE() << "no column " << name;
    return kNone;
  }
};

/// Cells of one line after another; a line feed ends a line unless it stands in quotes.
inline CsvTable read_csv(const std::string& text) {
  std::vector<std::vector<CsvCell>> lines(1);
  CsvCell cell;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (inside && letter == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cell.text += '"';
      ++i;
    } else if (letter == '"') {
      inside = !inside;
      cell.quoted = true;
    } else if (!inside && (letter == ',' || letter == '\n')) {
      lines.back().push_back(cell);
      cell = {};
      if (letter == '\n') {
        lines.emplace_back();
      }
    } else {
      cell.text += letter;
    }
  }
  EXPECT_FALSE(inside) << "a quote is not closed";
  EXPECT_TRUE(lines.back().empty()) << "the last line does not end";
  lines.pop_back();
  CsvTable table;
  for (const CsvCell& name : lines.at(0)) {
    table.names.push_back(name.text);
  }
  table.rows.assign(lines.begin() + 1, lines.end());
  for (const auto& row : table.rows) {
    EXPECT_EQ(row.size(), table.names.size());
  }
  return table;
}

}  // namespace impetus
