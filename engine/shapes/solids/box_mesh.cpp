// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/box_mesh.hpp"

namespace impetus::inline shapes {

TriangleMesh box_mesh(const Vector3& sides_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 signs(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(signs.cwiseProduct(sides_m));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace impetus::inline shapes
