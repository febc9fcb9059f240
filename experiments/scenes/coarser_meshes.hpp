// Makes the coarser meshes that a crowd is drawn with.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/tree_settings.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline scenes {

/// Meshes of half the triangles each, as far as `mesh` keeps its shape with so few; the same on
/// every machine. Precondition: find_defects(mesh).none().
[[nodiscard]] DrawnLevels coarser_meshes(const TriangleMesh& mesh, const Progress& progress = {});

}  // namespace impetus::inline scenes
