// Whether what a protocol asks to be solved can be asked of its scene; each refusal is one
// sentence. SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Kinds have their keys, pointers lead to what they solve, factors exist. Whether there is a
/// solution shows when it is looked for (solved_values.hpp). Throws InputError.
void check_solve(const Protocol& protocol);

}  // namespace impetus::inline protocol
