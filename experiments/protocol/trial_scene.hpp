// The scene of a planned trial, as JSON, and what decides its random start.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// With the trial's levels and what was solved for it put in.
nlohmann::json scene_of(const Protocol& protocol, const PlannedTrial& trial);

/// What a random start goes by: never the participant or the order of trials.
std::string start_of(const PlannedTrial& trial);

}  // namespace impetus::inline protocol
