// SPDX-License-Identifier: MIT
#include "engine/shapes/ball_distance.hpp"

#include <algorithm>
#include <cassert>

namespace impetus::inline shapes {

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

}  // namespace impetus::inline shapes
