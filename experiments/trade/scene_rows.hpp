// What a scene asks of collision handling, as rows.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/trade/scene_demand.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// Pairs of bodies that a step of the scene refines, of the steps that have any: their 95th
/// percentile; 1 when there is none.
double pairs_per_step(const SceneDemand& demand);

std::vector<TradeRow> scene_rows(const SceneDemand& demand, const std::string& title);

}  // namespace impetus::inline trade
