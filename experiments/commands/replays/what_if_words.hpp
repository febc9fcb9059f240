// What would have differed in recorded stimuli, as a table to read.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/commands/replays/what_if_sums.hpp"

namespace impetus::inline commands {

/// A line for each, and what they come to together.
std::string what_if_words(const std::vector<ComparedStimulus>& compared);

}  // namespace impetus::inline commands
