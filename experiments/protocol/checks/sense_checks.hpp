// What a protocol may say and cannot mean: it would record what nobody asked for. Files are held to
// it before anybody takes part. What a study has stored is not, and is replayed as it was run.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Of a protocol that has passed all other checks. Throws InputError.
void check_sense(const Protocol& protocol);

}  // namespace impetus::inline protocol
