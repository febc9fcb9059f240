// A line of tab-separated values as BIDS has them: no quotes; what is missing is "n/a".
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline tables {

/// The cells as one line, its end included; an empty cell becomes "n/a".
std::string tsv_line(const std::vector<std::string>& cells);

/// The text in UTF-8 on one line without tabs: there is no way to quote them.
std::string tsv_text(std::string_view text);

}  // namespace impetus::inline tables
