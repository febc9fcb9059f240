// SPDX-License-Identifier: MIT
#include "engine/shapes/point_in_solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline shapes {

bool contains(const TriangleMesh& solid, const Vector3& point) {
  // tan(Ω/2) = a·(b×c) / (|a||b||c| + a·b |c| + b·c |a| + c·a |b|)
  double half_angles = 0.0;
  for (const auto& triangle : solid.triangles) {
    const Vector3 a = solid.vertices[triangle[0]] - point;
    const Vector3 b = solid.vertices[triangle[1]] - point;
    const Vector3 c = solid.vertices[triangle[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    half_angles +=
        atan2_rad(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half_angles > std::numbers::pi;  // 2π inside, 0 outside
}

double distance_to_surface(const TriangleMesh& mesh, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    least = std::min(least, (closest_on_triangle(triangle, point) - point).squaredNorm());
  }
  return std::sqrt(least);
}

}  // namespace impetus::inline shapes
