// Whether a design's adaptive levels can be chosen at all; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// The adaptive factor has levels in order, one method chooses them, staircases start at one of
/// them, and answers that are positive or negative are asked for. Throws InputError.
void check_adaptive(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
