// What is asked of meshes by brute force, to hold quicker answers against.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/shapes/mesh_distance.hpp"
#include "engine/shapes/self_intersections.hpp"

namespace impetus {

/// Whether the surfaces cross. A mesh wholly inside another crosses nothing.
inline bool intersects(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                       const Pose& pose_b) {
  const auto placed = [](const TriangleMesh& mesh, const Pose& pose, std::size_t index) {
    const auto& [i, j, k] = mesh.triangles[index];
    return Triangle{pose.transform(mesh.vertices[i]), pose.transform(mesh.vertices[j]),
                    pose.transform(mesh.vertices[k])};
  };
  const auto box_of = [](const Triangle& triangle) {
    return std::pair(triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]).eval(),
                     triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]).eval());
  };
  for (std::size_t one = 0; one < a.triangles.size(); ++one) {
    const Triangle of_a = placed(a, pose_a, one);
    const auto [least_a, most_a] = box_of(of_a);
    for (std::size_t other = 0; other < b.triangles.size(); ++other) {
      const Triangle of_b = placed(b, pose_b, other);
      const auto [least_b, most_b] = box_of(of_b);
      if ((least_a.array() <= most_b.array()).all() && (least_b.array() <= most_a.array()).all() &&
          triangles_cross(of_a, of_b)) {
        return true;
      }
    }
  }
  return false;
}

/// Distance from `point` to the nearest triangle (metres).
inline double distance_to_surface(const TriangleMesh& mesh, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle triangle{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    least = std::min(least, (closest_on_triangle(triangle, point) - point).squaredNorm());
  }
  return std::sqrt(least);
}

/// find_self_intersections() by trying every pair.
inline SelfIntersections find_self_intersections_by_brute_force(const TriangleMesh& mesh) {
  SelfIntersections found;
  for (std::size_t a = 0; a < mesh.triangles.size(); ++a) {
    for (std::size_t b = a + 1; b < mesh.triangles.size(); ++b) {
      const TriangleMeeting how = meeting(mesh, mesh.triangles[a], mesh.triangles[b]);
      found.crossing_pairs += how == TriangleMeeting::kCrossing ? 1 : 0;
      found.folded_pairs += how == TriangleMeeting::kFolded ? 1 : 0;
    }
  }
  return found;
}

}  // namespace impetus
