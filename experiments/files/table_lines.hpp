// The lines of a table, separated by commas, tabs or semicolons, and where in the file they are.
//
//   blank lines                          are passed over, and counted
//   quotation marks                      stand around whole cells, and end in their line; one
//                                        within is doubled
//   blanks around a cell                 are no part of it
//   lines of fewer or more cells         than the first are refused, and bytes that are zero
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline files {

/// A line of a table.
struct TableLine {
  std::size_t number{0};  ///< in the file, from 1: for sentences
  std::vector<std::string> cells;
};

/// The lines that are not blank, with the same number of cells each. Throws InputError with the
/// name of `file`.
std::vector<TableLine> table_lines(const std::string& file, std::string_view text);

/// Throws InputError: "FILE:NUMBER: expected EXPECTED".
[[noreturn]] void refuse_table_line(const std::string& file, std::size_t number,
                                    const std::string& expected);

}  // namespace impetus::inline files
