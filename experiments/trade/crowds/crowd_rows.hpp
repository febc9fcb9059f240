// What orders of work did to a crowd, as rows of the table.
//
//   visible_gap, visible_bound        mean of a step, and its share of what shows at the roots
//   ..._removed                       per thousand units of work; as a multiple of what as much
//   work
//                                     removes by chance, breadth-first, and at most in hindsight
//   ..._removed without a budget      the same over all budgets together: areas under the curves
//   work, contacts, energy_change, time
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/trade/crowds/crowd_trade.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// `subject` is the scene's name.
std::vector<TradeRow> crowd_rows(const CrowdTrade& trade, const std::string& subject);

}  // namespace impetus::inline trade
