// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/torus_mesh.hpp"

#include <cassert>
#include <utility>

#include "engine/numerics/trigonometry.hpp"
#include "engine/shapes/solids/closed_tube.hpp"

namespace impetus::inline shapes {

TriangleMesh torus_mesh(double radius_m, double tube_m, int segments, int sides) {
  assert(0.0 < tube_m && tube_m < radius_m && segments >= 3 && sides >= 3);
  std::vector<Vector3> vertices;
  for (int segment = 0; segment < segments; ++segment) {
    const auto [sin_ring, cos_ring] = sine_cosine_deg(360.0 * segment / segments);
    for (int side = 0; side < sides; ++side) {
      const auto [sin_tube, cos_tube] = sine_cosine_deg(360.0 * side / sides);
      // From outside upward is clockwise as seen from ahead, hence the minus.
      const double from_axis_m = radius_m + tube_m * cos_tube;
      vertices.emplace_back(from_axis_m * cos_ring, from_axis_m * sin_ring, -tube_m * sin_tube);
    }
  }
  return closed_tube(std::move(vertices), sides);
}

}  // namespace impetus::inline shapes
