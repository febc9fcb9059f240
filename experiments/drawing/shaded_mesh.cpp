// SPDX-License-Identifier: MIT
#include "experiments/drawing/shaded_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "engine/numerics/trigonometry.hpp"

namespace impetus::inline drawing {
namespace {

/// Sets of corners; corner 3t+k is the k-th of triangle t.
class Groups {
 public:
  explicit Groups(std::size_t corners) : above_(corners) {
    std::iota(above_.begin(), above_.end(), 0U);
  }
  std::uint32_t of(std::uint32_t corner) {
    while (above_[corner] != corner) {
      above_[corner] = above_[above_[corner]];
      corner = above_[corner];
    }
    return corner;
  }
  void join(std::uint32_t one, std::uint32_t other) {
    const std::uint32_t a = of(one);
    const std::uint32_t b = of(other);
    above_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> above_;
};

/// One triangle's side between two vertices, and its corners there.
struct Side {
  std::uint32_t low_vertex;
  std::uint32_t high_vertex;
  std::uint32_t low_corner;
  std::uint32_t high_corner;

  [[nodiscard]] bool same_edge(const Side& other) const {
    return low_vertex == other.low_vertex && high_vertex == other.high_vertex;
  }
};

Vector3 unit_or_zero(const Vector3& v) {
  const double length = v.norm();
  return length > 0.0 ? Vector3(v / length) : Vector3(Vector3::Zero());
}

Vector3 face_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const Vector3& a = mesh.vertices[triangle[0]];
  return unit_or_zero((mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a));
}

std::vector<Vector3> face_normals(const TriangleMesh& mesh) {
  std::vector<Vector3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    normals.push_back(face_normal(mesh, triangle));
  }
  return normals;
}

double corner_angle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle,
                    std::size_t k) {
  const Vector3& apex = mesh.vertices[triangle[k]];
  const Vector3 one = mesh.vertices[triangle[(k + 1) % 3]] - apex;
  const Vector3 other = mesh.vertices[triangle[(k + 2) % 3]] - apex;
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

/// Sides in an order that puts those of one edge next to each other.
std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  std::uint32_t corner = 0;
  for (const auto& triangle : mesh.triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      const Side side{triangle[k], triangle[next], corner + k, corner + next};
      sides.push_back(side.low_vertex < side.high_vertex ? side
                                                         : Side{side.high_vertex, side.low_vertex,
                                                                side.high_corner, side.low_corner});
    }
    corner += 3;
  }
  std::sort(sides.begin(), sides.end(), [](const Side& one, const Side& other) {
    return std::array{one.low_vertex, one.high_vertex, one.low_corner} <
           std::array{other.low_vertex, other.high_vertex, other.low_corner};
  });
  return sides;
}

Groups joined_across_soft_edges(const TriangleMesh& mesh, const std::vector<Vector3>& normals,
                                double hard_edge_deg) {
  Groups groups(3 * mesh.triangles.size());
  const double least_cosine = sine_cosine_deg(hard_edge_deg).cosine;
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side& one = sides[i - 1];
    const Side& other = sides[i];
    if (one.same_edge(other) &&
        normals[one.low_corner / 3].dot(normals[other.low_corner / 3]) >= least_cosine) {
      groups.join(one.low_corner, other.low_corner);
      groups.join(one.high_corner, other.high_corner);
    }
  }
  return groups;
}

std::array<float, 3> as_floats(const Vector3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

ShadedMesh shaded_mesh(const TriangleMesh& mesh, double hard_edge_deg) {
  const std::vector<Vector3> normals = face_normals(mesh);
  Groups groups = joined_across_soft_edges(mesh, normals, hard_edge_deg);
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  std::vector<Vector3> sums(corners, Vector3::Zero());
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::size_t t = corner / 3;
    sums[groups.of(corner)] += corner_angle(mesh, mesh.triangles[t], corner % 3) * normals[t];
  }
  ShadedMesh result;
  std::vector<std::uint32_t> vertex_of(corners);
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::uint32_t group = groups.of(corner);
    if (group == corner) {  // the lowest of its group comes first
      vertex_of[corner] = static_cast<std::uint32_t>(result.vertices.size());
      const Vector3& position = mesh.vertices[mesh.triangles[corner / 3][corner % 3]];
      result.vertices.push_back({as_floats(position), as_floats(unit_or_zero(sums[group]))});
    }
    result.indices.push_back(vertex_of[group]);
  }
  return result;
}

}  // namespace impetus::inline drawing
