// The exact oracle: where two placed meshes, or a mesh and a ball, are closest, and where one that
// moves straight on first touches the other.
//
// Brute force over all pairs of triangles, culled by bounding boxes: slow, simple and right, to
// check the trees against and to measure the gap that a viewer saw. The first touch is found by
// conservative advancement:
//
//   way ──> closest points there ──> move on by their distance: nothing can meet before ──> way
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "engine/shapes/triangle_distance.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// The distance between the surfaces and their closest points, in world; 0 and a common point when
/// they cross. Both meshes need a triangle.
ClosestPoints mesh_distance(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                            const Pose& pose_b);

/// The distance between the surface of `mesh` (a) and the ball (b) and their closest points, in
/// world; 0 and a common point when they cross. A ball wholly inside the mesh is as far from its
/// surface as from outside. The mesh needs a triangle.
ClosestPoints ball_distance(const TriangleMesh& mesh, const Pose& pose, const Vector3& centre,
                            double radius_m);

/// Where two surfaces first touch.
struct FirstTouch {
  double way_m{0.0};      ///< how far the surface had moved
  ClosestPoints closest;  ///< just before the surfaces meet
};

/// The closest points of the surfaces once one has moved by `way_m`; 0 apart when they cross.
using ClosestAtWay = std::function<ClosestPoints(double way_m)>;

/// The first way at which the surfaces are within `gap_m` (> 0) of each other, and not less than
/// half of it; none when they are not before `farthest_m`, or cross at the start. A surface that
/// passes another so slowly by that 400 moves do not tell counts as passing it by.
/// (Mirtich 1996)
std::optional<FirstTouch> first_touch(const ClosestAtWay& closest_at, double gap_m,
                                      double farthest_m);

}  // namespace impetus::inline shapes
