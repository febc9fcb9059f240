// The exact oracle: do two placed meshes intersect, and if not, where are they closest?
//
// Brute force over all pairs of triangles, culled by bounding boxes: slow, simple and right, to
// check the trees against and to measure the gap that a viewer saw.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_distance.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// Whether the surfaces cross. A mesh wholly inside another crosses nothing.
bool intersects(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                const Pose& pose_b);

/// The distance between the surfaces and their closest points, in world; 0 and a common point when
/// they cross. Both meshes need a triangle.
ClosestPoints mesh_distance(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                            const Pose& pose_b);

}  // namespace impetus::inline shapes
