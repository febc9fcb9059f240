// Lines of CSV (RFC 4180, ended by a line feed: commas between, quotes where needed), and lines of
// tab-separated values as BIDS has them: no quotes; what is missing is "n/a".
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline tables {

/// The cells as one line, its end included; quotes where a text needs them.
std::string csv_line(const std::vector<std::string>& cells);

/// To nine digits, with a point whatever the user's language; "" when it is not finite.
std::string csv_number(double value);

/// Always in quotes, so that an empty text differs from a cell that is empty.
std::string csv_text(std::string_view text);

/// The letter x and the 64 bits as 16 hexadecimal digits: no program takes it for a number that it
/// would round to a double.
std::string bits_text(std::int64_t value);

/// The letter x and two hexadecimal digits for each byte.
std::string bytes_text(std::string_view bytes);

/// Of tab-separated values: the cells as one line, its end included; an empty cell becomes "n/a".
std::string tsv_line(const std::vector<std::string>& cells);

/// The text in UTF-8 on one line without tabs: there is no way to quote them.
std::string tsv_text(std::string_view text);

}  // namespace impetus::inline tables
