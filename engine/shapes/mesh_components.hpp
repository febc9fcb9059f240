// How the triangles of a mesh hang together: its components, and the corners where it is pinched.
//
//   two cubes that share a vertex: 2 components, 1 pinched vertex
//   two cubes that share an edge:  1 component, 1 crowded edge (see MeshDefects)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

struct MeshComponents {
  std::vector<std::uint32_t> of_triangle;  ///< from 0, by first triangle; joined by shared edges
  std::uint32_t count{0};
  std::int64_t pinched_vertices{0};  ///< whose triangles are more than one fan joined by edges
};

/// Every vertex index must be within `mesh.vertices`.
MeshComponents find_components(const TriangleMesh& mesh);

/// One mesh for each component, with its own vertices only.
std::vector<TriangleMesh> split(const TriangleMesh& mesh, const MeshComponents& components);

}  // namespace impetus::inline shapes
