// Bodies that look like the two that meet, and move straight on beside them without touching.
//
//      ●──────>          all in the plane of the screen, at the speed of the two; where they are
//   a ──>  <── b  ●      when is drawn until every path keeps its distance from every other at
//         <──────●       all times, the two's way there and back included
//
// (O'Sullivan, Radach and Collins 1999: look-alike distractors)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline scenes {

/// Adds the scene's distractors to the two bodies that meet, in turn like the first and the second.
void add_distractors(const Scene& scene, SceneBodies& bodies);

/// Their states beside `meeting`, those of the two, drawn with the trial's seed; none when no place
/// was found for them all. `hold_s` is the freeze at contact.
std::optional<std::vector<BodyState>> distractor_states(const Scene& scene,
                                                        const SceneBodies& bodies,
                                                        const std::vector<BodyState>& meeting,
                                                        const Viewer& viewer, double hold_s,
                                                        std::uint64_t seed);

/// Adds what is wrong with distractors beyond the schema; all else about the meeting is right.
void add_distractor_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems);

}  // namespace impetus::inline scenes
