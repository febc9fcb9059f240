// What the figures of a scene must fulfil beyond the schemas.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// Whether the scene has figures or a crowd of them.
bool has_figures(const nlohmann::json& scene);

/// Adds what is wrong with the figures and their files, as far as it shows before any is built: in
/// a scene that has figures. Precondition: valid by the schemas, as far as files are held.
void add_figure_problems(const nlohmann::json& scene, std::vector<SceneProblem>& problems);

/// Adds what is wrong with where a scene's named bodies and figures start: any that overlap, at the
/// coarsest level at which they may stay, and parts that are folded onto their neighbours.
/// Precondition: as for build_scene(), and no crowd.
void add_overlap_problems(const nlohmann::json& scene, std::vector<SceneProblem>& problems);

}  // namespace impetus::inline scenes
