// Whether the questions of a protocol, and what goes by their answers, fit the rest of it; each
// refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// There is something to answer, unless the protocol has no participants; what a question names is
/// a factor of the design. Throws InputError.
void check_responses(const JsonDocument& protocol);

/// Training has practice conditions and a question with a right answer, and is the only rule.
/// Throws InputError.
void check_training(const JsonDocument& protocol);

/// Of two intervals, the standard can be shown under every condition. `protocol` has its design and
/// script. Throws InputError.
void check_standard(const Protocol& protocol);

}  // namespace impetus::inline protocol
