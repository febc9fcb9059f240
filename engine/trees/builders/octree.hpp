// The octree of spheres: cubes that touch the solid, each bounded by the sphere of what it holds.
//
//   +---+---+---+---+      A cell's part is solid ∩ cell. Its corners are those of the surface
//   |   |  /    |   |      clipped to the cell and the cell's own corners inside the solid, so a
//   |   | /:::::|   |      sphere round these points bounds the part.
//   +---+---+---+---+
//   | ::|:::|:::|   |      Children split the cell in eight; parts that are empty have no node.
//   +---+---+---+---+      A sphere that lies wholly inside the solid is a leaf: nothing finer
//                          would change what it says.
//
// Invariant, up to 1e-13 of the solid's size: cells of a level are disjoint and cover the solid, a
// child's cell lies in its parent's, and every node's sphere holds its part, hence the parts of all
// nodes below it. (Hubbard 1996; Dingliana 2002, sec. 3.1.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// The tree, and the cells that its nodes were made of.
struct Octree {
  VolumeTree tree;
  std::vector<Bounds> cells;  ///< one per node, in the tree's order (body frame)
};

/// The greatest depth that build_octree() takes.
inline constexpr int kGreatestOctreeDepth = 8;

/// A tree of `depth` + 1 levels (fewer when nothing finer would change anything); its root sphere
/// lies about the origin, the centre of mass. Throws std::invalid_argument when the mesh is not
/// closed or `depth` not from 0 to 8.
Octree build_octree(const TriangleMesh& solid, int depth);

/// build_octree(solid, depth).tree
VolumeTree octree(const TriangleMesh& solid, int depth);

}  // namespace impetus::inline trees
