// SPDX-License-Identifier: MIT
#include "experiments/drawing/shaded_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "engine/numerics/disjoint_sets.hpp"
#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline drawing {
namespace {

Vector3 unit_or_zero(const Vector3& v) {
  const double length = v.norm();
  return length > 0.0 ? Vector3(v / length) : Vector3(Vector3::Zero());
}

std::vector<Vector3> face_normals(const TriangleMesh& mesh) {
  std::vector<Vector3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices[triangle[0]];
    normals.push_back(
        unit_or_zero((mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a)));
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

/// Sets of corners, of which 3t + k is the k-th of triangle t.
/// Takes the triangles one after the other: across each edge, a triangle's two corners join those
/// of the triangle that had the edge before, where the normals of the two are near each other.
DisjointSets groups_across_soft_edges(const TriangleMesh& mesh, const std::vector<Vector3>& normals,
                                      double hard_edge_deg) {
  /// A triangle's corners at the two vertices of an edge, that of the lower vertex first.
  using Side = std::array<std::uint32_t, 2>;
  DisjointSets groups(3 * mesh.triangles.size());
  const double least_cosine = sine_cosine_deg(hard_edge_deg).cosine;
  std::unordered_map<std::uint64_t, Side> last_of_edge;
  last_of_edge.reserve(2 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t low = mesh.triangles[t][k];
      std::uint32_t high = mesh.triangles[t][(k + 1) % 3];
      Side side{3 * t + k, 3 * t + (k + 1) % 3};
      if (low > high) {
        std::swap(low, high);
        std::swap(side[0], side[1]);
      }
      const auto [at, is_new] =
          last_of_edge.try_emplace(static_cast<std::uint64_t>(high) << 32U | low, side);
      if (!is_new && normals[at->second[0] / 3].dot(normals[t]) >= least_cosine) {
        groups.join(at->second[0], side[0]);
        groups.join(at->second[1], side[1]);
      }
      at->second = side;
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
  DisjointSets groups = groups_across_soft_edges(mesh, normals, hard_edge_deg);
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  std::vector<Vector3> sums(corners, Vector3::Zero());
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::size_t t = corner / 3;
    sums[groups.name_of(corner)] += corner_angle(mesh, mesh.triangles[t], corner % 3) * normals[t];
  }
  ShadedMesh result;
  std::vector<std::uint32_t> vertex_of(corners);
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::size_t group = groups.name_of(corner);
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
