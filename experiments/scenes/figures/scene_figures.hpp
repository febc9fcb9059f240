// A scene's figures: their parts as bodies, the hinges between them, how they start, and whether
// they may start so: apart from each other, but where a hinge joins two, and none folded.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline scenes {

/// Adds the parts of each figure the scene names, or of its crowd of figures ("1/head"), and the
/// figures themselves, driven ones with their motion. Precondition: `scene` holds its figure files,
/// and add_figure_problems() adds none.
void add_figures(const Scene& scene, const ShapeFrame& frame, ShapeLibrary& library,
                 SceneBodies& bodies);

/// The states of the parts of the figures that the scene names, in the order of `bodies`; driven
/// ones with the momenta of their motion over a step of `step_s`.
std::vector<BodyState> figure_states(const Scene& scene, const SceneBodies& bodies,
                                     double metres_per_degree, double step_s);

/// Whether a hinge of the figure joins the two bodies.
bool are_neighbours(const Figure& figure, std::int32_t a, std::int32_t b);

/// Whether the figure's own rules leave out the pair: both are its parts, and neighbours, or others
/// where self_collision has no others.
bool leaves_out(const Figure& figure, std::int32_t a, std::int32_t b);

/// The first hinge that the poses fold past its threshold, where neighbours may collide; else null.
const Hinge* folded_hinge(const Figure& figure, const std::vector<Pose>& poses);

}  // namespace impetus::inline scenes
