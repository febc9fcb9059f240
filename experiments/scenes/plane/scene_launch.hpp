// A launch in the plane, imposed on two bodies that pass through all others.
//
//      first ────> ▯        ▯ second      lead_s: the first moves until gap_px is left between
//               ──── gap ────             the outlines along the way, and stops
//                        ▯ ▯ ────>        after the hold the second moves off, for follow_s
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline scenes {

/// Puts the first where it starts, and says how it stops before a hold of `hold_s`. Precondition:
/// add_launch_problems() adds none.
Launch launch_of(const Scene& scene, double metres_per_degree, double hold_s, SceneBodies& bodies,
                 std::vector<BodyState>& states);

/// How both move on.
std::vector<ImposedMotion> motions_of(const Scene& scene, const Launch& launch,
                                      double metres_per_degree);

/// Adds what is wrong with it: it needs a plane, and two bodies of it with outlines.
void add_launch_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
