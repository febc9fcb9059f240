// Rows of words for a terminal, in aligned columns, and numbers as people read them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace impetus::inline tables {

/// What stands in a study is anybody's text: on a terminal its control characters are shown as
/// \x1b and do nothing, so that one value stays in its place in one line.
std::string printable(const std::string& text);

/// The rows as lines, each column as wide as its longest cell (in characters; bytes of UTF-8 that
/// go on with one are not counted), two spaces between. Cells are made printable. The last column
/// is not filled up.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

/// To two digits, as people write numbers: 0.012, 6.3, 140; "?" when it is not finite.
std::string two_digits(double value);

/// The same, or "< 0.1" of what is less than `least`.
std::string two_digits_from(double least, double value);

}  // namespace impetus::inline tables
