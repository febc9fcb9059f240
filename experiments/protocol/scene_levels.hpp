// Levels that a protocol leaves to the scene: null, in whose place the scene's own value is put.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// Puts what the scene says in place of levels that are null: design and script are read anew.
/// Pointers that the scene lacks are left to the checks of the design.
void take_levels_of_scene(Protocol& protocol, const nlohmann::json& scene);

}  // namespace impetus::inline protocol
