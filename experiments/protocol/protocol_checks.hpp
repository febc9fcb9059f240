// What a protocol must fulfil beyond its schema; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus {

/// Names, pointers, practice conditions, runs and the scale agree with each other and the scene.
/// Throws InputError.
void check_design(const JsonDocument& protocol, const JsonDocument& scene);

/// Every level, put into the scene, leaves a scene that can be shown. Throws InputError.
void check_levels(const Protocol& protocol);

/// Every duration that must fall on the display's frames does. `allow_rounding` lets an imposed
/// hold be rounded; what was realised is stored. Throws InputError.
void check_frames(const Protocol& protocol, double refresh_hz, bool allow_rounding);

}  // namespace impetus
