// What the figures of a scene, and their files, must fulfil beyond the schemas: trees of hinges
// whose angles, names and motions fit, apart from all else at the start.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_problems.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline scenes {

/// Adds what is wrong with the figures and their files, as far as it shows before any is built: in
/// a scene that has figures.
void add_figure_problems(const Scene& scene, SceneProblems& problems);

/// Adds what is wrong with where a scene's named bodies and figures start: any that overlap, at the
/// coarsest level at which they may stay, and parts that are folded onto their neighbours.
/// Precondition: as for build_scene(), and no crowd.
void add_overlap_problems(const Scene& scene, ShapeLibrary& library, SceneProblems& problems);

}  // namespace impetus::inline scenes
