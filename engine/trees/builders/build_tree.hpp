// Builds a volume tree of any kind round a solid.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/tree_settings.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// Raised when a change makes any builder's tree differ: trees of another version are built anew.
/// Recordings depend on their trees, so kRecordingFormat (engine/world/world_settings.hpp) rises
/// too.
inline constexpr int kTreeBuilderVersion = 2;

/// A tree of at most levels_to_build(settings) + 1 levels, fewer when nothing finer would change
/// anything, in the frame of `solid`, which should be about its centre of mass. Every level covers
/// the whole surface. The result is the same, bit for bit, on every machine. Throws
/// std::invalid_argument when the mesh is not closed or problem_of(settings) is not empty.
VolumeTree build_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress = {});

}  // namespace impetus::inline trees
