// Two bodies that meet: where they start, and the invisible shells of those that must not touch.
//
//        a ──────>    (  )    <────── b        at_deg: the place of the screen where they touch
//                                              offset_deg: b's line of approach apart from a's
//        drawn (  ) gap (  ) drawn             gap_arcmin: spheres of half a gap more collide
//
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_bodies.hpp"
#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// Gives the two bodies the shells that leave the scene's gap between what is drawn, as `viewer`
/// sees it; nothing where it asks for none. Precondition: meeting_problems() is empty.
void add_shells(const nlohmann::json& scene, const Viewer& viewer, SceneBodies& bodies);

/// Where both start, and how fast (`bodies` after add_shells()).
std::vector<BodyState> meeting_states(const nlohmann::json& scene, const Viewer& viewer,
                                      const SceneBodies& bodies);

/// What is wrong with offset and gap beyond the schema; all else about the meeting is right.
std::vector<SceneProblem> meeting_problems(const nlohmann::json& scene);

}  // namespace impetus::inline scenes
