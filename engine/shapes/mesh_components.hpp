// How the triangles of a mesh hang together: its components, and the corners where it is pinched.
//
//   two cubes that share a vertex: 2 components, 1 pinched vertex
//   two cubes that share an edge:  1 component, 1 crowded edge (see MeshDefects)
//
// And which way round they must be for a closed mesh to bound a solid.
//
//   +-----------+   A component inside an even number of others is a body and looks outward; inside
//   | +---+     |   an odd number it is a cavity and looks inward. Then every point is inside once
//   | |   | -->-|-> or not at all.
//   | +---+     |
//   +-----------+
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// Which triangles hang together.
struct MeshComponents {
  std::vector<std::uint32_t> of_triangle;  ///< from 0, by first triangle; joined by shared edges
  std::uint32_t count{0};
  std::int64_t pinched_vertices{0};  ///< whose triangles are more than one fan joined by edges
};

/// Every vertex index must be within `mesh.vertices`.
MeshComponents find_components(const TriangleMesh& mesh);

/// One mesh for each component, with its own vertices only.
std::vector<TriangleMesh> split(const TriangleMesh& mesh, const MeshComponents& components);

/// What is to be done with each component.
struct ComponentOrientation {
  std::vector<bool> flat;    ///< encloses no more than the rounding of its coordinates
  std::vector<bool> turned;  ///< a body that looks inward or a cavity that looks outward
};

/// One entry for each component. Thickness is volume over area: a component thinner than 2^-22 of
/// its diagonal is flat, as single-precision coordinates are rounded by 2^-24. One component counts
/// as inside another when its box is and sixteen of its vertices are. Precondition:
/// find_defects(mesh).none().
ComponentOrientation orientation_of(const TriangleMesh& mesh, const MeshComponents& components);

}  // namespace impetus::inline shapes
