// Where two drawn bodies are closest, exactly: meshes, balls, or one of each.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_distance.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

/// Of the bodies' own meshes and balls, in world; 0 apart when the surfaces cross.
ClosestPoints closest_surfaces(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                               const Pose& pose_b);

}  // namespace impetus::inline run
