// A choice as the settings of a scene, to be pasted back.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/trade/trade_option.hpp"

namespace impetus {

/// The scene's "engine" with the option's kind of tree, its level as the deepest, and its
/// reduction. A schedule stays, its lists no deeper than the level; a single level becomes the
/// option's. What the option does not decide stays as it is. Precondition: `scene` is valid.
nlohmann::json engine_with(const nlohmann::json& scene, const TradeOption& option);

/// The scene in which every collision is handled as the option says: without schedule and budget.
nlohmann::json scene_with(nlohmann::json scene, const TradeOption& option);

}  // namespace impetus
