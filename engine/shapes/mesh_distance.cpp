// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_distance.hpp"

#include <cassert>
#include <limits>
#include <vector>

namespace impetus {
namespace {

/// A triangle in world with its bounding box.
struct PlacedTriangle {
  Triangle corners;
  Vector3 least;
  Vector3 most;
};

std::vector<PlacedTriangle> placed(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<PlacedTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle corners{pose.transform(mesh.vertices[a]), pose.transform(mesh.vertices[b]),
                           pose.transform(mesh.vertices[c])};
    triangles.push_back({corners, corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
                         corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])});
  }
  return triangles;
}

/// Squared distance of the boxes: 0 when they overlap, never more than that of the triangles.
double squared_box_distance(const PlacedTriangle& a, const PlacedTriangle& b) {
  const Vector3 apart = (a.least - b.most).cwiseMax(b.least - a.most).cwiseMax(0.0);
  return apart.squaredNorm();
}

}  // namespace

bool intersects(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                const Pose& pose_b) {
  const std::vector<PlacedTriangle> of_b = placed(b, pose_b);
  for (const PlacedTriangle& one : placed(a, pose_a)) {
    for (const PlacedTriangle& other : of_b) {
      if (squared_box_distance(one, other) == 0.0 && triangles_cross(one.corners, other.corners)) {
        return true;
      }
    }
  }
  return false;
}

ClosestPoints mesh_distance(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                            const Pose& pose_b) {
  assert(!a.triangles.empty() && !b.triangles.empty());
  const std::vector<PlacedTriangle> of_b = placed(b, pose_b);
  ClosestPoints best{std::numeric_limits<double>::infinity(), {}, {}};
  for (const PlacedTriangle& one : placed(a, pose_a)) {
    for (const PlacedTriangle& other : of_b) {
      if (squared_box_distance(one, other) < best.distance_m * best.distance_m) {
        const ClosestPoints found = triangle_distance(one.corners, other.corners);
        if (found.distance_m < best.distance_m) {
          best = found;
        }
      }
    }
  }
  return best;
}

}  // namespace impetus
