// What of a surface a level of a volume tree leaves bare: a proof, independent of who built it.
//
//       ____________         A piece of a triangle whose corners all lie in one node lies in it,
//      /\    V      \        for nodes are convex. Otherwise the hull of the corners in V and of
//     /  \ held      |       the crossings of the piece's edges with V lies in V too, and only
//    /rest\__________|       the rest goes on to the other nodes. Where no node takes anything
//   /______\________/        from a piece, it is halved.
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// The area of `mesh` outside every node that stands for it at `level` (m²), 0 when all is covered.
/// Never less than the truth but for pieces narrower than 1e-12 of the mesh's size, which count as
/// covered; a piece not settled within 100 halvings counts as bare.
double uncovered_area_m2(const TriangleMesh& mesh, const VolumeTree& tree, int level);

}  // namespace impetus::inline trees
