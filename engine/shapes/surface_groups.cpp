// SPDX-License-Identifier: MIT
#include "engine/shapes/surface_groups.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "engine/shapes/mesh_reduction.hpp"
#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline shapes {
namespace {

constexpr std::int32_t kNoGroup = -1;
/// A triangle takes its group from one that does not face away by more than 60°.
constexpr double kCompatibleCosine = 0.5;

Triangle corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

std::vector<Vector3> area_vectors_of(const TriangleMesh& mesh) {
  std::vector<Vector3> vectors;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    vectors.emplace_back(0.5 * (b - a).cross(c - a));
  }
  return vectors;
}

using Neighbours = std::vector<std::array<std::uint32_t, 3>>;

/// The triangle across each edge.
Neighbours neighbours_of(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_edge;
  for (std::uint32_t index = 0; index < mesh.triangles.size(); ++index) {
    const auto& triangle = mesh.triangles[index];
    for (std::size_t i = 0; i < 3; ++i) {
      by_edge[{triangle[i], triangle[(i + 1) % 3]}] = index;
    }
  }
  Neighbours neighbours(mesh.triangles.size());
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const auto& triangle = mesh.triangles[index];
    for (std::size_t i = 0; i < 3; ++i) {
      neighbours[index][i] = by_edge.at({triangle[(i + 1) % 3], triangle[i]});
    }
  }
  return neighbours;
}

/// Grows groups over a mesh until every triangle has one.
class Growth {
 public:
  explicit Growth(const TriangleMesh& mesh)
      : areas_(area_vectors_of(mesh)),
        neighbours_(neighbours_of(mesh)),
        groups_(mesh.triangles.size(), kNoGroup) {}

  std::vector<std::int32_t> groups() {
    std::vector<std::uint32_t> largest_first(areas_.size());
    std::iota(largest_first.begin(), largest_first.end(), 0U);
    std::stable_sort(largest_first.begin(), largest_first.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                       return areas_[a].squaredNorm() > areas_[b].squaredNorm();
                     });
    std::int32_t group = 0;
    for (const std::uint32_t seed : largest_first) {
      if (groups_[seed] == kNoGroup) {
        grow(seed, group++);
      }
    }
    return groups_;
  }

 private:
  /// By how parallel it was when it was seen, then by the lower index.
  using Seen = std::tuple<double, std::int64_t>;

  [[nodiscard]] double cosine(std::uint32_t triangle, const Vector3& normal) const {
    return areas_[triangle].normalized().dot(normal.normalized());
  }

  void grow(std::uint32_t seed, std::int32_t group) {
    Vector3 normal = Vector3::Zero();
    std::priority_queue<Seen> seen;
    seen.emplace(1.0, -static_cast<std::int64_t>(seed));
    while (!seen.empty()) {
      const auto triangle = static_cast<std::uint32_t>(-std::get<1>(seen.top()));
      seen.pop();
      const bool first = normal.isZero();
      if (groups_[triangle] != kNoGroup || (!first && cosine(triangle, normal) < kGroupCosine)) {
        continue;
      }
      groups_[triangle] = group;
      normal += areas_[triangle];
      for (const std::uint32_t next : neighbours_[triangle]) {
        if (groups_[next] == kNoGroup) {
          seen.emplace(cosine(next, normal), -static_cast<std::int64_t>(next));
        }
      }
    }
  }

  std::vector<Vector3> areas_;
  Neighbours neighbours_;
  std::vector<std::int32_t> groups_;
};

/// The triangle of `mesh` nearest to `point` that faces along `normal`; any that is nearest when
/// none does.
std::size_t facing_nearest(const TriangleMesh& mesh, const std::vector<Vector3>& normals,
                           const Vector3& point, const Vector3& normal) {
  using Rank = std::pair<bool, double>;
  Rank best{true, std::numeric_limits<double>::infinity()};
  std::size_t found = 0;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const bool faces_away = normals[triangle].dot(normal) < kCompatibleCosine;
    const Vector3 nearest = closest_on_triangle(corners_of(mesh, triangle), point);
    const Rank rank{faces_away, (nearest - point).squaredNorm()};
    if (rank < best) {
      best = rank;
      found = triangle;
    }
  }
  return found;
}

}  // namespace

std::vector<std::int32_t> surface_groups(const TriangleMesh& mesh) {
  if (mesh.triangles.size() <= kFineMesh) {
    return Growth(mesh).groups();
  }
  const TriangleMesh coarse = reduced_mesh(mesh, kReducedMesh);
  const std::vector<std::int32_t> coarse_groups = Growth(coarse).groups();
  std::vector<Vector3> normals = area_vectors_of(coarse);
  for (Vector3& normal : normals) {
    normal.normalize();
  }
  const std::vector<Vector3> areas = area_vectors_of(mesh);
  std::vector<std::int32_t> groups;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    const std::size_t nearest =
        facing_nearest(coarse, normals, (a + b + c) / 3.0, areas[triangle].normalized());
    groups.push_back(coarse_groups[nearest]);
  }
  return groups;
}

}  // namespace impetus::inline shapes
