// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_distance.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

namespace impetus::inline shapes {
namespace {

/// A triangle in world with its bounding box.
struct PlacedTriangle : Bounds {
  Triangle corners;
};

std::vector<PlacedTriangle> placed(const TriangleMesh& mesh, const Pose& pose) {
  std::vector<PlacedTriangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Triangle corners{pose.transform(mesh.vertices[a]), pose.transform(mesh.vertices[b]),
                           pose.transform(mesh.vertices[c])};
    triangles.push_back({bounds_of(corners), corners});
  }
  return triangles;
}

/// Squared distance of the boxes: 0 when they overlap, never more than that of the triangles.
double squared_box_distance(const Bounds& a, const Bounds& b) {
  const Vector3 apart = (a.least - b.most).cwiseMax(b.least - a.most).cwiseMax(0.0);
  return apart.squaredNorm();
}

/// Neighbours in a mesh's list are mostly neighbours in space, so a box about a few spares them
/// all.
constexpr std::size_t kBlock = 16;

/// About each kBlock triangles in their order.
std::vector<Bounds> blocks_of(const std::vector<PlacedTriangle>& triangles) {
  std::vector<Bounds> blocks;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % kBlock == 0) {
      blocks.push_back(triangles[i]);
    }
    blocks.back().include(triangles[i]);
  }
  return blocks;
}

/// The first corner nearest to `point`.
Vector3 nearest_corner(const std::vector<PlacedTriangle>& triangles, const Vector3& point) {
  const Vector3* nearest = &triangles.front().corners[0];
  double least = (*nearest - point).squaredNorm();
  for (const PlacedTriangle& triangle : triangles) {
    for (const Vector3& corner : triangle.corners) {
      const double distance = (corner - point).squaredNorm();
      if (distance < least) {
        least = distance;
        nearest = &corner;
      }
    }
  }
  return *nearest;
}

/// No less than the distance, and mostly not much more: between two corners, found in turns.
double upper_bound_m(const std::vector<PlacedTriangle>& a, const std::vector<PlacedTriangle>& b) {
  constexpr double kBeyondRounding = 1.0 + 1e-9;
  const Vector3 on_b = nearest_corner(b, a.front().corners[0]);
  const Vector3 on_a = nearest_corner(a, on_b);
  const double bound_m = (nearest_corner(b, on_a) - on_a).norm() * kBeyondRounding;
  return bound_m > 0.0 ? bound_m : std::numeric_limits<double>::infinity();
}

}  // namespace

ClosestPoints mesh_distance(const TriangleMesh& a, const Pose& pose_a, const TriangleMesh& b,
                            const Pose& pose_b) {
  assert(!a.triangles.empty() && !b.triangles.empty());
  const std::vector<PlacedTriangle> of_a = placed(a, pose_a);
  const std::vector<PlacedTriangle> of_b = placed(b, pose_b);
  const std::vector<Bounds> blocks_of_a = blocks_of(of_a);
  const std::vector<Bounds> blocks_of_b = blocks_of(of_b);
  ClosestPoints best{upper_bound_m(of_a, of_b), {}, {}};
  const auto may_be_nearer = [&best](const Bounds& one, const Bounds& other) {
    return squared_box_distance(one, other) < best.distance_m * best.distance_m;
  };
  // Of triangles equally near the first in the lists' order counts: nothing is asked out of turn.
  std::vector<std::size_t> near_blocks;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (i % kBlock == 0) {
      near_blocks.clear();
      for (std::size_t block = 0; block < blocks_of_b.size(); ++block) {
        if (may_be_nearer(blocks_of_a[i / kBlock], blocks_of_b[block])) {
          near_blocks.push_back(block);
        }
      }
    }
    for (const std::size_t block : near_blocks) {
      if (!may_be_nearer(of_a[i], blocks_of_b[block])) {
        continue;
      }
      const std::size_t end = std::min(of_b.size(), (block + 1) * kBlock);
      for (std::size_t other = block * kBlock; other < end; ++other) {
        if (may_be_nearer(of_a[i], of_b[other])) {
          const ClosestPoints found = triangle_distance(of_a[i].corners, of_b[other].corners);
          best = found.distance_m < best.distance_m ? found : best;
        }
      }
    }
  }
  return best;
}

ClosestPoints ball_distance(const TriangleMesh& mesh, const Pose& pose, const Vector3& centre,
                            double radius_m) {
  assert(!mesh.triangles.empty());
  const Vector3 centre_B = pose.orientation.conjugate() * (centre - pose.position);
  Vector3 nearest_B = mesh.vertices[mesh.triangles.front()[0]];
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3 point_B =
        closest_on_triangle({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, centre_B);
    if ((point_B - centre_B).squaredNorm() < (nearest_B - centre_B).squaredNorm()) {
      nearest_B = point_B;
    }
  }
  const Vector3 on_mesh = pose.transform(nearest_B);
  const double from_centre_m = (on_mesh - centre).norm();
  if (from_centre_m <= radius_m) {
    return {0.0, on_mesh, on_mesh};
  }
  return {from_centre_m - radius_m, on_mesh,
          centre + radius_m / from_centre_m * (on_mesh - centre)};
}

std::optional<FirstTouch> first_touch(const ClosestAtWay& closest_at, double gap_m,
                                      double farthest_m) {
  constexpr int kMostMoves = 400;
  double way_m = 0.0;
  for (int move = 0; move < kMostMoves && way_m <= farthest_m; ++move) {
    const ClosestPoints closest = closest_at(way_m);
    if (closest.distance_m <= gap_m) {
      return closest.distance_m > 0.0 ? std::optional(FirstTouch{way_m, closest}) : std::nullopt;
    }
    way_m += closest.distance_m - 0.5 * gap_m;
  }
  return std::nullopt;
}

}  // namespace impetus::inline shapes
