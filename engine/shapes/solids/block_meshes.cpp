// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/block_meshes.hpp"

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

TriangleMesh l_block_mesh(double arm_m, double thickness_m) {
  // The outline counter-clockwise as seen from +z; corner 3 is the inner one, and sees all others.
  constexpr std::uint32_t kCorners = 6;
  constexpr std::uint32_t kInner = 3;
  const double outline[kCorners][2] = {{0.0, 0.0},           {arm_m, 0.0},
                                       {arm_m, thickness_m}, {thickness_m, thickness_m},
                                       {thickness_m, arm_m}, {0.0, arm_m}};
  TriangleMesh mesh;
  for (const double z : {-0.5 * thickness_m, 0.5 * thickness_m}) {
    for (const auto& corner : outline) {
      mesh.vertices.emplace_back(corner[0], corner[1], z);
    }
  }
  for (std::uint32_t corner = 0; corner < kCorners; ++corner) {
    const std::uint32_t next = (corner + 1) % kCorners;
    if (corner != kInner && next != kInner) {
      mesh.triangles.push_back({kInner, next, corner});
      mesh.triangles.push_back({kInner + kCorners, corner + kCorners, next + kCorners});
    }
    mesh.triangles.push_back({corner, next, next + kCorners});
    mesh.triangles.push_back({corner, next + kCorners, corner + kCorners});
  }
  return mesh;
}

}  // namespace impetus::inline shapes
