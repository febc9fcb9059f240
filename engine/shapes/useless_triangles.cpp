// SPDX-License-Identifier: MIT
#include "engine/shapes/useless_triangles.hpp"

#include <algorithm>
#include <set>

namespace impetus::inline shapes {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Says of each triangle in turn whether its vertices have come before.
class Duplicates {
 public:
  bool operator()(Corners triangle) {
    std::sort(triangle.begin(), triangle.end());
    return !seen_.insert(triangle).second;
  }

 private:
  std::set<Corners> seen_;
};

template <typename IsUseless>
std::int64_t drop(TriangleMesh& mesh, IsUseless is_useless) {
  std::vector<Corners> kept;
  for (const Corners& triangle : mesh.triangles) {
    if (!is_useless(triangle)) {
      kept.push_back(triangle);
    }
  }
  kept.swap(mesh.triangles);
  return static_cast<std::int64_t>(kept.size() - mesh.triangles.size());
}

}  // namespace

bool is_degenerate(const TriangleMesh& mesh, const Corners& triangle) {
  const Vector3& a = mesh.vertices[triangle[0]];
  const Vector3& b = mesh.vertices[triangle[1]];
  const Vector3& c = mesh.vertices[triangle[2]];
  return (b - a).cross(c - a).squaredNorm() == 0.0;
}

std::int64_t drop_degenerate(TriangleMesh& mesh) {
  return drop(mesh, [&mesh](const Corners& triangle) { return is_degenerate(mesh, triangle); });
}

std::int64_t drop_duplicates(TriangleMesh& mesh) { return drop(mesh, Duplicates()); }

std::int64_t count_duplicates(const TriangleMesh& mesh) {
  std::int64_t count = 0;
  Duplicates is_duplicate;
  for (const Corners& triangle : mesh.triangles) {
    count += is_duplicate(triangle) ? 1 : 0;
  }
  return count;
}

}  // namespace impetus::inline shapes
