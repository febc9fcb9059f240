// Whether two triangles of a mesh have more in common than the corners they share, without
// rounding.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

enum class TriangleMeeting {
  kNone,      ///< nothing in common, or only shared corners and edges
  kCrossing,  ///< a common point although no corner is shared; touching counts
  kFolded,    ///< a common point beyond the shared corner, or beyond the shared edge
};

/// How triangles `a` and `b` of `mesh` meet: kNone when they are the same three vertices or when
/// one of them has no area. Corners are told apart by their index, so vertices must be welded.
TriangleMeeting meeting(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& a,
                        const std::array<std::uint32_t, 3>& b);

}  // namespace impetus::inline shapes
