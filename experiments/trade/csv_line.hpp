// A line of CSV (RFC 4180): commas between, quotes where a text needs them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace impetus {

/// The cells as one line, its end included.
std::string csv_line(const std::vector<std::string>& cells);

/// To nine digits, with a point whatever the user's language; "" when it is not finite.
std::string csv_number(double value);

}  // namespace impetus
