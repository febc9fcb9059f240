// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/icosphere_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

namespace impetus::inline shapes {
namespace {

/// The twelve vertices are the corners of three golden rectangles.
TriangleMesh icosahedron() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  mesh.vertices = {{-1.0, golden, 0.0},  {1.0, golden, 0.0},   {-1.0, -golden, 0.0},
                   {1.0, -golden, 0.0},  {0.0, -1.0, golden},  {0.0, 1.0, golden},
                   {0.0, -1.0, -golden}, {0.0, 1.0, -golden},  {golden, 0.0, -1.0},
                   {golden, 0.0, 1.0},   {-golden, 0.0, -1.0}, {-golden, 0.0, 1.0}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// Splits triangles in four; two that share an edge share its midpoint.
class Splitter {
 public:
  explicit Splitter(TriangleMesh& mesh) : mesh_(&mesh) {}

  void split_all() {
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh_->triangles) {
      const std::uint32_t ab = midpoint(a, b);
      const std::uint32_t bc = midpoint(b, c);
      const std::uint32_t ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh_->triangles.swap(finer);
  }

 private:
  std::uint32_t midpoint(std::uint32_t from, std::uint32_t to) {
    const auto fresh = static_cast<std::uint32_t>(mesh_->vertices.size());
    const auto [entry, added] = midpoints_.try_emplace(std::minmax(from, to), fresh);
    if (added) {
      mesh_->vertices.push_back(
          (mesh_->vertices[from].normalized() + mesh_->vertices[to].normalized()).eval());
    }
    return entry->second;
  }

  TriangleMesh* mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints_;
};

}  // namespace

TriangleMesh icosphere_mesh(double radius_m, int subdivisions) {
  assert(subdivisions >= 0 && subdivisions <= 7);
  TriangleMesh mesh = icosahedron();
  for (int round = 0; round < subdivisions; ++round) {
    Splitter(mesh).split_all();
  }
  for (Vector3& vertex : mesh.vertices) {
    vertex = radius_m * vertex.normalized();
  }
  return mesh;
}

}  // namespace impetus::inline shapes
