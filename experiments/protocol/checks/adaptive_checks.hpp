// Whether a design's adaptive levels can be chosen at all, and their threshold be found; each
// refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// The adaptive factor has levels in order, one method chooses them, staircases start at one of
/// them, and answers that are positive or negative are asked for. A staircase settles above the
/// share that guessing reaches. The psychometric functions that QUEST+ chooses among rise from a
/// guess rate to above it, are defined at every level, have their thresholds between the levels,
/// and are few enough. Throws InputError.
void check_adaptive(const Protocol& protocol);

}  // namespace impetus::inline protocol
