// Whether a design's catch trials can be shown; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Every catch trial has a level for every factor, of the same type as the factor's own, and no
/// two kinds are alike. Throws InputError.
void check_catch_trials(const JsonDocument& protocol);

/// Every catch trial leaves a scene that can be shown. Throws InputError.
void check_catch_scenes(const Protocol& protocol);

}  // namespace impetus::inline protocol
