// Trees whose volumes are fitted to parts of the surface, from the whole downwards: of oriented
// boxes, of swept spheres, of whatever suits each node.
//
//   part of a node  --cut in two where it fits best, worst piece first-->  at most `branching`
//   parts
//                   --a volume fitted to each-->  its children
//
// Invariant: parts are only cut, never dropped, and each volume is grown until it holds every
// corner of its part; so the children of a node hold the whole of its part. A volume that would
// reach farther than its parent's is replaced by that. (after Gottschalk et al. 1996)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/node_description.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// A tree of kind kBox, kSwept or kHeterogeneous of at most `settings.depth` + 1 levels. A node
/// that reaches no farther beyond the object than 1e-9 of its size has no children, nor one that
/// reaches no farther than 5e-4 of it when they would be no better. Throws
/// std::invalid_argument when `solid` is none or problem_of(settings) is not empty.
BuiltTree build_fitted_tree(const TriangleMesh& solid, const TreeSettings& settings,
                            const Progress& progress = {});

}  // namespace impetus::inline trees
