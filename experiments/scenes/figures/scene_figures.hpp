// A scene's figures: their parts as bodies, the hinges between them, and how they start.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline scenes {

/// Adds the parts of each figure the scene names, or of its crowd of figures ("1/head"), and the
/// figures themselves, driven ones with their motion. Precondition: `scene` is valid by the
/// schemas, holds its figure files, and figure_file_problems() finds nothing.
void add_figures(const nlohmann::json& scene, const ShapeFrame& frame, ShapeLibrary& library,
                 SceneBodies& bodies);

/// The states of the parts of the figures that the scene names, in the order of `bodies`; driven
/// ones with the momenta of their motion over a step of `step_s`.
std::vector<BodyState> figure_states(const nlohmann::json& scene, const SceneBodies& bodies,
                                     double metres_per_degree, double step_s);

}  // namespace impetus::inline scenes
