// The exact distance between two triangles, where they are closest, and whether one reaches into a
// box.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/numerics/vector.hpp"

namespace impetus::inline shapes {

using Triangle = std::array<Vector3, 3>;

/// Two points, one on each shape, that no other two are closer than; distance 0 when they meet.
struct ClosestPoints {
  double distance_m{0.0};
  Vector3 on_a{Vector3::Zero()};
  Vector3 on_b{Vector3::Zero()};
};

/// What of a triangle a point lies on. Edge i runs from corner i to the next.
enum class TriangleFeature { kCorner0, kCorner1, kCorner2, kEdge0, kEdge1, kEdge2, kFace };

/// A point of a triangle, and what of it that lies on.
struct ClosestOnTriangle {
  Vector3 point;
  TriangleFeature feature;
};

/// The point of `triangle` nearest to `point`, and what it lies on. (Ericson 2005, sec. 5.1.5)
ClosestOnTriangle closest_feature(const Triangle& triangle, const Vector3& point);

/// closest_feature().point
Vector3 closest_on_triangle(const Triangle& triangle, const Vector3& point);

/// Segments a0–a1 and b0–b1. (Ericson 2005, sec. 5.1.9)
ClosestPoints segment_distance(const Vector3& a0, const Vector3& a1, const Vector3& b0,
                               const Vector3& b1);

/// Nine pairs of edges, six corners against faces, six edges through faces.
ClosestPoints triangle_distance(const Triangle& a, const Triangle& b);

/// Whether an edge of one passes through the other. Coplanar triangles never cross.
bool triangles_cross(const Triangle& a, const Triangle& b);

/// Whether the triangle meets the box |x_i| ≤ half_extents_m[i], by the thirteen separating axes
/// (Akenine-Möller 2001): false is certain up to rounding, true where they touch.
bool meets_box(const Triangle& triangle, const Vector3& half_extents_m);

}  // namespace impetus::inline shapes
