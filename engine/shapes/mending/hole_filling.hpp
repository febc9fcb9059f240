// Closing the holes of a consistently oriented surface with as little new area as possible.
//
//   open edges --followed, cut where a vertex comes again--> simple loops --> triangles
//
// A loop of n edges takes n - 2 triangles and no new vertex; a flat hole is closed in its plane.
// (Barequet and Sharir 1995: the triangulation of least area, by dynamic programming)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// The most edges of a hole that is filled: beyond it, what was there is anybody's guess.
inline constexpr std::int64_t kLargestHole = 64;

/// How many holes were filled, and with what.
struct HoleFilling {
  std::int64_t holes{0};        ///< filled
  std::int64_t edges{0};        ///< of the holes filled, together
  std::int64_t triangles{0};    ///< added
  std::int64_t large_holes{0};  ///< left open: more than kLargestHole edges
  std::int64_t stuck_holes{0};  ///< left open: nothing closes them without a new defect
};

/// Fills what holes it can. Precondition: no edge of `mesh` has more than two triangles and none is
/// misoriented.
HoleFilling fill_holes(TriangleMesh& mesh);

}  // namespace impetus::inline shapes
