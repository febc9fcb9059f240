// What would have differed in recorded stimuli, as files.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/commands/replays/what_if_sums.hpp"

namespace impetus::inline commands {

/// CSV: a row for each, after a line of names. Times in seconds, empty where nothing parted.
std::string what_if_csv(const std::vector<ComparedStimulus>& compared);

/// The same, with every collision, and the totals.
nlohmann::json what_if_json(const std::vector<ComparedStimulus>& compared);

}  // namespace impetus::inline commands
