// The surface on which a function of space is zero, as a mesh that cannot fail to be a solid.
//
//   +-----+     Every cube of a grid is cut in six tetrahedra about the diagonal from its least
//   |    /|     to its greatest corner (Freudenthal 1942; Kuhn 1960), so that the faces of
//   |  /  |     neighbours match. Within a tetrahedron the corners' signs alone choose a triangle,
//   |/    |     a quadrilateral or nothing. (Doi and Koide 1991)
//   +-----+
//
// Why it is always closed and never crosses itself: a vertex lies strictly inside an edge of the
// grid and is shared by all that meet there, a face of a tetrahedron has one segment or none, and a
// piece of surface stays in its own tetrahedron.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// Cubes of edge `cell_m` from the corner `least` on, `cells` along each axis.
struct SampleGrid {
  Vector3 least{Vector3::Zero()};
  double cell_m{1.0};
  std::array<int, 3> cells{1, 1, 1};
};

/// The boundary of where `value` is negative, outward, about one function call per grid point.
/// Vertices keep a tenth of an edge from the grid's points, so no triangle is degenerate.
/// Precondition: `value` is nowhere negative on the outside of the grid.
TriangleMesh level_set_mesh(const std::function<double(const Vector3&)>& value,
                            const SampleGrid& grid);

}  // namespace impetus::inline shapes
