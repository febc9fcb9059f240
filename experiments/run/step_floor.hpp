// The floor of a scene: what its steps take on this machine of which nothing is granted. They move
// bodies, find who may meet, and keep everybody within the walls; no budget can hold below it.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/deadline_work.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

/// The longest step of the floor, in milliseconds by `clock`, of the scene's first 300. The same
/// steps are taken three times, and the middle time of each counts: the longest is often what else
/// the machine did, and the shortest is less than a budget must have room for.
[[nodiscard]] double floor_ms(const StagedScene& scene, const WorkClock& clock);

}  // namespace impetus::inline run
