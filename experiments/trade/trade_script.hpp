// The script that draws the figure of a trade (analysis/trade.R), as built into the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace impetus::inline trade {

/// An R script: Rscript trade.R trade.csv writes trade.svg and trade.pdf beside the table.
std::string_view trade_script();

}  // namespace impetus::inline trade
