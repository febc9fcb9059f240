// SPDX-License-Identifier: MIT
#include "experiments/run/closest_surfaces.hpp"

#include <algorithm>
#include <utility>

#include "engine/shapes/mesh_distance.hpp"

namespace impetus::inline run {
namespace {

/// Two balls need no mesh: the closest points lie on the line of their centres.
ClosestPoints distance_of_balls(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                                const Pose& pose_b) {
  const Vector3 a_to_b = pose_b.position - pose_a.position;
  const double distance = a_to_b.norm();
  const Vector3 along = distance > 0.0 ? Vector3(a_to_b / distance) : Vector3::UnitX();
  const double gap_m = std::max(0.0, distance - a.radius_m - b.radius_m);
  const Vector3 on_a = pose_a.position + a.radius_m * along;
  return {gap_m, on_a, on_a + gap_m * along};
}

}  // namespace

ClosestPoints closest_surfaces(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                               const Pose& pose_b) {
  if (a.mesh && b.mesh) {
    return mesh_distance(*a.mesh, pose_a, *b.mesh, pose_b);
  }
  if (a.mesh) {
    return ball_distance(*a.mesh, pose_a, pose_b.position, b.radius_m);
  }
  if (b.mesh) {
    ClosestPoints closest = ball_distance(*b.mesh, pose_b, pose_a.position, a.radius_m);
    std::swap(closest.on_a, closest.on_b);
    return closest;
  }
  return distance_of_balls(a, pose_a, b, pose_b);
}

}  // namespace impetus::inline run
