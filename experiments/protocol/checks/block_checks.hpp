// Whether a design's blocks can be made; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/settings/json_document.hpp"

namespace impetus::inline protocol {

/// Blocks are made of factors of the design. Throws InputError.
void check_blocks(const JsonDocument& protocol);

}  // namespace impetus::inline protocol
