// Whether a simulated participant can do what a protocol asks; each refusal is one sentence.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// The observer rates on the protocol's scale, where it has one, clicks where clicks are asked for,
/// and has an eye where the gaze is followed. Throws InputError.
void check_observer(const Protocol& protocol, const ObserverFile& observer);

}  // namespace impetus::inline protocol
