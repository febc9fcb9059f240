// A choice as the settings of a scene, to be pasted back.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/trade/trade_option.hpp"

namespace impetus::inline trade {

/// The scene's "engine" with trees of the option's kind to `depth`, as they were measured, its
/// level as the deepest that is used, and its reduction. A schedule stays, its lists no deeper than
/// the level; without one the level is stated. What the option does not decide stays as it is.
/// Preconditions: `scene` is valid; the option's level is at most `depth`.
nlohmann::json engine_with(const nlohmann::json& scene, const TradeOption& option, int depth);

/// The scene in which every collision is handled as the option says: without schedule and budget.
nlohmann::json scene_with(nlohmann::json scene, const TradeOption& option, int depth);

}  // namespace impetus::inline trade
