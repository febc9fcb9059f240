// Where a surface passes through itself: every pair of its triangles that meets beyond what the two
// share.
//
//   triangles --halved along the longest side--> tree of boxes --against itself--> pairs --exact-->
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

struct SelfIntersections {
  std::int64_t crossing_pairs{0};  ///< triangles without a common corner that cross or touch
  std::int64_t folded_pairs{0};    ///< neighbours that meet beyond their common corner or edge

  [[nodiscard]] std::int64_t pairs() const { return crossing_pairs + folded_pairs; }
};

/// Counts the pairs of a mesh with finite vertices, welded: corners are told apart by their index.
/// Triangles without area and duplicates meet nothing. Time grows with the pairs whose boxes
/// overlap. See meeting().
SelfIntersections find_self_intersections(const TriangleMesh& mesh);

}  // namespace impetus::inline shapes
