// A factor's level as files have it, and conditions made of such levels.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/design/design.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline questions {

/// A word, true or false, or else a number; 0 for null, in whose place the scene's own value is
/// put.
LevelValue level_value(const nlohmann::json& value);
Kind<LevelValue> factor_level_kind();
/// The same, or null.
Kind<LevelValue> own_level_kind();

/// A level for every factor, {"delay_ms": 100, ...}, in the order of the names.
Kind<Condition> condition_kind();

/// A whole number stays one, so that 100 is stored as 100 and not as 100.0.
nlohmann::json to_json(const LevelValue& value);
nlohmann::json to_json(const Condition& condition);

/// All of its levels, in the order of the names.
Condition condition_from_json(const nlohmann::json& object);
/// In the order of the design's factors. It lacks what the object lacks: an adaptive level that is
/// not chosen yet.
Condition condition_from_json(const nlohmann::json& object, const Design& design);

/// The levels as a file lists them, for messages.
std::string list_text(const std::vector<LevelValue>& levels);

/// The factor of this name. Throws InputError when the design has none; `place` is where the
/// protocol names it.
const Factor& named_factor(const JsonDocument& protocol, const std::string& place,
                           const Design& design, const std::string& name);

/// The same; refuses one that is between participants, of which a session has one level.
const Factor& factor_within(const JsonDocument& protocol, const std::string& place,
                            const Design& design, const std::string& name);

/// A value in quotes or a number, as a file has it, for messages.
inline std::string json_text(const LevelValue& value) { return to_json(value).dump(); }

}  // namespace impetus::inline questions
