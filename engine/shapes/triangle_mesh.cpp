// SPDX-License-Identifier: MIT
#include "engine/shapes/triangle_mesh.hpp"

#include <map>
#include <utility>

#include "engine/shapes/useless_triangles.hpp"

namespace impetus::inline shapes {
namespace {

struct EdgeUse {
  int forward{0};
  int backward{0};
};

}  // namespace

MeshDefects find_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  for (const Vector3& vertex : mesh.vertices) {
    defects.bad_vertices += vertex.allFinite() ? 0 : 1;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeUse> edges;
  for (const auto& triangle : mesh.triangles) {
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

}  // namespace impetus::inline shapes
