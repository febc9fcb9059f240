// The voxel tree: cubes of a regular grid that the solid touches, their places implicit.
//
//   +---+---+---+---+      A cell is split into k³, k³ the branching. Cells that hold surface, and
//   |   |  /|   |   |      cells inside the solid, are nodes; a cell wholly inside is a leaf: no
//   |   | /:|:::|   |      finer cells would say more.
//   +---+---+---+---+
//   | ::|:::|:::|   |      A face in the wall between two cells belongs to the one that the solid
//   +---+---+---+---+      lies in; what lies nearer to a wall than 1e-13 of the size lies in it.
//
// Invariant: cells of a level are disjoint but for their walls and cover the solid, a child's cell
// lies in its parent's, and every node's cube, a margin of 1e-12 of the grid wider than its cell,
// holds the node's part of the surface. (Dingliana 2002, sec. 4.1.2)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/node_description.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// A tree of kind kVoxel of at most `settings.depth` + 1 levels; a part without facets is of a cell
/// wholly inside the solid. Throws std::invalid_argument when `solid` is none or
/// problem_of(settings) is not empty.
BuiltTree build_voxel_tree(const TriangleMesh& solid, const TreeSettings& settings,
                           const Progress& progress = {});

}  // namespace impetus::inline trees
