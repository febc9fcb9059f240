// The medial sphere-tree: for every node the few spheres near the medial axis that cover its part
// and reach least beyond the solid.
//
//   part --samples, medial balls--> cover --power cells--> parts of the children --grow--> spheres
//
// A child's part is the piece of its parent's nearest to the child's sphere by power distance, cut
// out by planes; its radius then grows to the farthest corner. Invariant: every node holds its
// part, and the parts of its children tile it. (Hubbard 1996; Bradshaw and O'Sullivan 2004)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/node_description.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// See build_tree().
BuiltTree medial_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress = {});

}  // namespace impetus::inline trees
