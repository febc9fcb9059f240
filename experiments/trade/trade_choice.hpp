// What to choose for each budget, checked by running the scene with it.
//
//   options within the budget, best first ──run the scene──> the first whose steps keep to it
//
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/trade/trade_option.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// The scene's "engine" with trees of the option's kind to `depth`, as they were measured, its
/// level as the deepest that is used, and its reduction. A schedule stays, its lists no deeper than
/// the level; without one the level is stated. What the option does not decide stays as it is.
/// Preconditions: `scene` is valid; the option's level is at most `depth`.
nlohmann::json engine_with(const nlohmann::json& scene, const TradeOption& option, int depth);

/// The scene in which every collision is handled as the option says: without schedule and budget.
nlohmann::json scene_with(nlohmann::json scene, const TradeOption& option, int depth);

/// "oriented boxes to level 3 with grouped averages"
std::string words_for(const TradeOption& option);

/// "median normal error 6°, 95 % of gaps below 9 minutes of arc"
std::string error_words(const TradeOption& option);

/// What to choose within one budget, and what it took when the scene ran with it.
struct TradeChoice {
  double budget_ms{0.0};
  TradeOption option;
  double pairs_ms{0.0};  ///< what the pairs of a step take, from what they took one by one
  double step_ms{0.0};   ///< 95th percentile of the steps of the scene run with it; NaN: none touch
  bool keeps{true};      ///< to the budget, both; the quickest option is given when none does
};

/// Milliseconds of a step of the scene run with an option: its 95th percentile. Asked for some
/// options more than once.
using RunScene = std::function<double(const TradeOption& option)>;

/// One choice for each budget, in their order. Precondition: there is an option.
std::vector<TradeChoice> choices_for(const std::vector<double>& budgets_ms,
                                     const std::vector<TradeOption>& options, double pairs,
                                     const RunScene& run_scene);

/// "within 4 ms, oriented boxes to level 3 with grouped averages: median normal error 6°, 95 % of
/// gaps below 9 minutes of arc."
std::string advice(const TradeChoice& choice);

/// As a table to read, with a sentence for every choice and what its numbers rest on.
std::string choices_page(const std::vector<TradeChoice>& choices, const std::string& title,
                         double pairs);

/// The same numbers as CSV.
std::string choices_csv(const std::vector<TradeChoice>& choices);

}  // namespace impetus::inline trade
