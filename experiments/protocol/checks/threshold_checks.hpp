// Whether an adaptive method can find the threshold that it looks for; each refusal is one
// sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// A staircase settles above the share that guessing reaches. The psychometric functions that
/// QUEST+ chooses among rise from a guess rate to above it, are defined at every level, have their
/// thresholds between the levels, and are few enough. The adaptive design is otherwise checked.
/// Throws InputError.
void check_thresholds(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
