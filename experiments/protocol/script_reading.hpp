// What a session says and asks, read from a protocol's checked JSON.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/questions/script.hpp"

namespace impetus::inline protocol {

/// `document` is the whole protocol; where nobody takes part, only the title is read.
Script script_from(const nlohmann::json& document);

}  // namespace impetus::inline protocol
