// Where a surface passes through itself: every pair of its triangles that meets beyond what the two
// share.
//
//   triangles --halved along the longest side--> tree of boxes --against itself--> pairs --exact-->
//
// How two of them meet, and on which side of a line or a plane a point lies, is told without
// rounding:
//
//   determinant in doubles --beyond its error bound--> sign
//                          --within it--> the same determinant as an exact sum --> sign
//
// (Shewchuk 1997: the bound of his orient3d, grow-expansion and two-product)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "engine/numerics/vector.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// The sign of (b - a) × (c - a) · (d - a): +1 when `d` is where `a`, `b`, `c` run
/// counter-clockwise, 0 when all four lie in one plane. Coordinates (metres) must be finite and,
/// but for zero, their products of three neither overflow nor underflow.
int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

/// The same in the plane that is left when coordinate `axis` (0, 1, 2) is dropped: +1 when `a`,
/// `b`, `c` run counter-clockwise as seen from the positive end of that axis, 0 when they are in
/// line.
int turn_across(int axis, const Vector3& a, const Vector3& b, const Vector3& c);

/// What two triangles have in common.
enum class TriangleMeeting {
  kNone,      ///< nothing in common, or only shared corners and edges
  kCrossing,  ///< a common point although no corner is shared; touching counts
  kFolded,    ///< a common point beyond the shared corner, or beyond the shared edge
};

/// How triangles `a` and `b` of `mesh` meet: kNone when they are the same three vertices or when
/// one of them has no area. Corners are told apart by their index, so vertices must be welded.
TriangleMeeting meeting(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& a,
                        const std::array<std::uint32_t, 3>& b);

/// How many pairs of triangles meet.
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
