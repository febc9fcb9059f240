// The exact oracle for a ball and a mesh: see mesh_distance.hpp.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_distance.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// The distance between the surface of `mesh` (a) and the ball (b) and their closest points, in
/// world; 0 and a common point when they cross. A ball wholly inside the mesh is as far from its
/// surface as from outside. The mesh needs a triangle.
ClosestPoints ball_distance(const TriangleMesh& mesh, const Pose& pose, const Vector3& centre,
                            double radius_m);

}  // namespace impetus::inline shapes
