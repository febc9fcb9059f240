// How deep a protocol's collisions can be refined, whatever is shown: no tree need be deeper.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// The deepest level that any condition of the design, practice or catch trial, standard interval
/// or demonstration can reach.
int deepest_level_of(const Protocol& protocol);

}  // namespace impetus::inline protocol
