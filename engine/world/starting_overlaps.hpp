// Bodies that already touch before anything has moved: a start that a study should refuse.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/world/world.hpp"

namespace impetus::inline world {

/// The pairs that touch in the world's present state at `level` of their trees (at the finest when
/// it is deeper), walls included as {body, kEnclosure}; in order of (a, b).
std::vector<BodyPair> overlapping_at_start(const World& world, int level = kUnlimitedLevel);

}  // namespace impetus::inline world
