// The design of a protocol, read from its checked JSON; conditions to JSON and back.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/design/design.hpp"
#include "experiments/record/script.hpp"

namespace impetus::inline protocol {

/// The design without its practice. `object` is the protocol's "design", checked.
Design design_from(const nlohmann::json& object);

/// When practice is understood, if the design says so.
std::optional<PracticeRule> practice_rule_from(const nlohmann::json& design);

/// When training is over, if the design says so.
std::optional<TrainingRule> training_rule_from(const nlohmann::json& design);

/// Whether one of the factors of the protocol's "design" is called so.
bool has_factor(const nlohmann::json& design, const std::string& name);

/// A whole number stays one, so that 100 is stored as 100 and not as 100.0.
nlohmann::json to_json(const LevelValue& value);

/// {"delay_ms": 100, ...} and back. A condition lacks what the object lacks: an adaptive level that
/// is not chosen yet.
nlohmann::json to_json(const Condition& condition);
Condition condition_from_json(const nlohmann::json& object, const Design& design);

}  // namespace impetus::inline protocol
