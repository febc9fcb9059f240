// A factor's level as a protocol writes it.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/design/design.hpp"

namespace impetus::inline questions {

/// A word, true or false, or else a number.
LevelValue level_value(const nlohmann::json& value);

}  // namespace impetus::inline questions
