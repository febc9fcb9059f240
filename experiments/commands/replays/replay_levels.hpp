// The adaptive levels of a study, derived anew from its answers.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/study/replay_library.hpp"

namespace impetus::inline commands {

/// Where the adaptive levels of a study differ from what their tracks choose anew.
std::vector<LevelDivergence> divergent_levels(StudyFile& study, ReplayLibrary& library);

/// Compares the adaptive levels of these attempts' trials with what their tracks choose anew,
/// prints each that differs, and returns how many there are.
std::int64_t compare_levels(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                            ReplayLibrary& library);

}  // namespace impetus::inline commands
