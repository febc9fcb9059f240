// SPDX-License-Identifier: MIT
#include "engine/shapes/triangle_mesh.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace impetus::inline shapes {
namespace {

/// How many triangles run along an edge, either way.
struct EdgeUse {
  int forward{0};
  int backward{0};
};

using Corners = std::array<std::uint32_t, 3>;

}  // namespace

Bounds bounds_of(std::span<const Vector3> points) {
  Bounds bounds{points.front(), points.front()};
  for (const Vector3& point : points) {
    bounds.include(point);
  }
  return bounds;
}

Bounds bounds_of(const TriangleMesh& mesh) {
  const Vector3& first = mesh.vertices[mesh.triangles.front()[0]];
  Bounds bounds{first, first};
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      bounds.include(mesh.vertices[vertex]);
    }
  }
  return bounds;
}

MeshDefects find_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  for (const Vector3& vertex : mesh.vertices) {
    defects.bad_vertices += vertex.allFinite() ? 0 : 1;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges;
  for (const auto& triangle : mesh.triangles) {
    if (*std::max_element(triangle.begin(), triangle.end()) >= mesh.vertices.size()) {
      ++defects.unknown_vertices;
      continue;
    }
    defects.degenerate_triangles += is_degenerate(mesh, triangle) ? 1 : 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = triangle[corner];
      const std::uint32_t to = triangle[(corner + 1) % 3];
      from < to ? ++edges[{from, to}].forward : ++edges[{to, from}].backward;
    }
  }
  for (const auto& [edge, use] : edges) {
    const int triangles = use.forward + use.backward;
    if (triangles == 1) {
      ++defects.open_edges;
    } else if (triangles > 2) {
      ++defects.crowded_edges;
    } else if (use.forward != 1) {
      ++defects.misoriented_edges;
    }
  }
  return defects;
}

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
