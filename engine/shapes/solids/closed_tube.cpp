// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/closed_tube.hpp"

#include <cassert>
#include <utility>

namespace impetus::inline shapes {

TriangleMesh closed_tube(std::vector<Vector3> vertices, int sides) {
  const auto count = static_cast<std::uint32_t>(vertices.size());
  const auto corners = static_cast<std::uint32_t>(sides);
  assert(sides >= 3 && count % corners == 0 && count >= 3 * corners);
  TriangleMesh mesh{std::move(vertices), {}};
  for (std::uint32_t ring = 0; ring < count; ring += corners) {
    const std::uint32_t ahead = (ring + corners) % count;
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      const std::uint32_t next = (corner + 1) % corners;
      mesh.triangles.push_back({ring + corner, ring + next, ahead + next});
      mesh.triangles.push_back({ring + corner, ahead + next, ahead + corner});
    }
  }
  return mesh;
}

}  // namespace impetus::inline shapes
