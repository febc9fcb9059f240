// SPDX-License-Identifier: MIT
#include "engine/shapes/useless_triangles.hpp"

#include <algorithm>
#include <set>

namespace impetus::inline shapes {
namespace {

using Corners = std::array<std::uint32_t, 3>;

}  // namespace

bool is_degenerate(const TriangleMesh& mesh, const Corners& triangle) {
  const Vector3& a = mesh.vertices[triangle[0]];
  const Vector3& b = mesh.vertices[triangle[1]];
  const Vector3& c = mesh.vertices[triangle[2]];
  return (b - a).cross(c - a).squaredNorm() == 0.0;
}

std::int64_t count_duplicates(const TriangleMesh& mesh) {
  std::set<Corners> seen;
  std::int64_t count = 0;
  for (Corners triangle : mesh.triangles) {
    std::sort(triangle.begin(), triangle.end());
    count += seen.insert(triangle).second ? 0 : 1;
  }
  return count;
}

}  // namespace impetus::inline shapes
