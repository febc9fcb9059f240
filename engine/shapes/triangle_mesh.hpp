// A triangle mesh in memory, whether its surface encloses a solid, and the triangles that add
// nothing to it: without area, or there already.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline shapes {

/// Vertices in metres; each triangle lists three of them counter-clockwise as seen from outside.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A box parallel to the axes (metres): its least and its greatest corner.
struct Bounds {
  Vector3 least{Vector3::Zero()};
  Vector3 most{Vector3::Zero()};

  [[nodiscard]] Vector3 sides() const { return most - least; }
  [[nodiscard]] Vector3 middle() const { return 0.5 * (least + most); }
  [[nodiscard]] bool overlaps(const Bounds& other) const {
    return (least.array() <= other.most.array()).all() &&
           (other.least.array() <= most.array()).all();
  }
  void include(const Vector3& point) { include(Bounds{point, point}); }
  void include(const Bounds& other) {
    least = least.cwiseMin(other.least);
    most = most.cwiseMax(other.most);
  }
};

/// Of one point or more.
Bounds bounds_of(std::span<const Vector3> points);

/// Of the triangles, one or more: vertices of no triangle do not count.
Bounds bounds_of(const TriangleMesh& mesh);

/// What keeps a mesh from being a solid: all zero for a closed, consistently oriented surface.
struct MeshDefects {
  std::int64_t open_edges{0};            ///< edges with one triangle
  std::int64_t misoriented_edges{0};     ///< edges that two triangles run along the same way
  std::int64_t crowded_edges{0};         ///< edges with more than two triangles
  std::int64_t degenerate_triangles{0};  ///< a repeated vertex or no area
  std::int64_t bad_vertices{0};          ///< not finite
  std::int64_t unknown_vertices{0};      ///< triangles of a vertex that there is not

  [[nodiscard]] bool none() const {
    return open_edges == 0 && misoriented_edges == 0 && crowded_edges == 0 &&
           degenerate_triangles == 0 && bad_vertices == 0 && unknown_vertices == 0;
  }
};

/// Counts the defects of a mesh. It does not tell whether the surface is inside out, as a whole or
/// a part of it: the volume of its solid (mass_properties.hpp) is then below 0, or smaller.
MeshDefects find_defects(const TriangleMesh& mesh);

/// Whether the triangle has a repeated vertex or no area.
bool is_degenerate(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle);

/// How many triangles have the vertices of an earlier one, either way round.
std::int64_t count_duplicates(const TriangleMesh& mesh);

}  // namespace impetus::inline shapes
