// What a step of a scene takes, measured by running it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/trade/trade_option.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// Milliseconds of each step in which bodies touch, all phases included, without budget: of the
/// whole scene, or of what can be run in `most_s` seconds. Empty when nothing touches.
std::vector<double> step_times_ms(const StagedScene& scene, const Clock& clock, double most_s);

/// The same as rows of the part "run": median, p95 and p99, for the option that the scene ran with.
std::vector<TradeRow> run_rows(const std::string& title, const TradeOption& option,
                               const std::vector<double>& times_ms);

}  // namespace impetus::inline trade
