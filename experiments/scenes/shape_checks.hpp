// What a scene's shape must fulfil beyond the schema: the measures of its kind, and that they fit.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/scenes/scene_checks.hpp"

namespace impetus::inline scenes {

/// Adds what is wrong with the shape at `place`, at most one problem: each kind needs its own
/// measures and takes no other's; `resolution` is for kinds whose fineness is a choice; a mesh is
/// among the scene's `meshes`. Precondition: both are valid by the scene's schema.
void add_shape_problems(const nlohmann::json& shape, const nlohmann::json& meshes,
                        const std::string& place, std::vector<SceneProblem>& problems);

}  // namespace impetus::inline scenes
