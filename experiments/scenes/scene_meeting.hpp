// Two bodies that meet: where they start, and the invisible shells of those that must not touch.
//
//        a ──────>    (  )    <────── b        at_deg: the place of the screen where they touch
//                                              offset_deg: b's line of approach apart from a's
//        a ──────>    (  ) b                   second_rests
//        drawn (  ) gap (  ) drawn             gap_arcmin: spheres of half a gap more collide
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline scenes {

/// Gives the two bodies the shells that leave the scene's gap between what is drawn, as `viewer`
/// sees it; nothing where it asks for none. Precondition: add_touching_problems() adds none.
void add_shells(const Scene& scene, const Viewer& viewer, SceneBodies& bodies);

/// Where both start, and how fast (`bodies` after add_shells()).
std::vector<BodyState> meeting_states(const Scene& scene, const Viewer& viewer,
                                      const SceneBodies& bodies);

/// Adds what is wrong with offset and gap beyond the schema; all else about the meeting is right.
void add_touching_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems);

}  // namespace impetus::inline scenes
