// The figure of a trade, by R where there is one.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace impetus::inline commands {

/// Writes the figure's script, trade.R, into `folder` beside trade.csv and runs it with Rscript.
/// What to tell the user: that trade.svg and trade.pdf are written, or what is missing and how to
/// make them then.
std::string draw_trade_figure(const std::filesystem::path& folder);

}  // namespace impetus::inline commands
