// A mesh of fewer triangles that keeps the shape: edges are drawn together, the cheapest first.
//
//     \ | /            \ | /
//    --u-v--   ──>    ---w---      w: where the squared distances to the planes that u and v
//     / | \            / | \       stand for are least
//
// An edge is taken only if the surface stays a closed manifold (the link condition) and no triangle
// round it turns over, so a closed mesh stays one. (Garland and Heckbert 1997)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// `mesh` with at most `triangles` triangles, or as few as the shape allows: two fewer for each
/// edge that can go. Vertices keep their order. The same on every machine. Precondition:
/// find_defects(mesh).none().
TriangleMesh reduced_mesh(const TriangleMesh& mesh, std::size_t triangles);

}  // namespace impetus::inline shapes
