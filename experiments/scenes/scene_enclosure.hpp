// The walls that a scene puts round its bodies: a closed cube, or what the viewer sees.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/scheduling/viewer.hpp"
#include "engine/volumes/enclosure.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// None when the scene has none. A cube grows with the count of a crowd where the scene says so.
/// Precondition: add_enclosure_problems() adds none.
std::optional<Enclosure> enclosure_of(const Scene& scene, double metres_per_degree,
                                      const Viewer& viewer);

/// The screen by which a scene is checked, for a view frustum has its shape: 37.6 × 30.1 cm seen
/// from 57 cm, the measures assumed where none were entered.
ScreenGeometry screen_for_checks();

/// Adds what is wrong with the keys of the enclosure's kind.
void add_enclosure_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
