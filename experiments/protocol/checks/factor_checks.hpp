// What a design's factors must keep to: each overrides a value of the scene, or the keys of a
// question.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Names, places and levels. Throws InputError.
void check_factors(const Protocol& protocol);

}  // namespace impetus::inline protocol
