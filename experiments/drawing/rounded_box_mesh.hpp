// The mesh of a rounded box, by which volumes of every kind are drawn.
//
//   half extents   0 0 0   a 0 0    a b 0       a b c
//   radius         r       r        r           0
//   volume         sphere  line-    rectangle-  box, cube
//                          swept    swept
//
// It is a sphere cut in eight along its axes, the pieces moved to the corners of the box, and
// the gaps closed by strips and faces: one mesh, stretched for each volume as it is drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline drawing {

/// In the world, of a body at `pose`.
RoundedBox posed(const RoundedBox& box, const Pose& pose);

/// Corners and triangles that any rounded box is drawn with.
struct RoundedBoxMesh {
  /// A vertex lies at centre + axes (corner ∘ half_extents_m + radius_m · normal); its own normal
  /// is axes · normal.
  struct Vertex {
    std::array<float, 3> corner;  ///< ±1 each
    std::array<float, 3> normal;  ///< unit
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise from outside
};

/// `parts` ≥ 1: into how many a quarter of a great circle is cut.
RoundedBoxMesh rounded_box_mesh(int parts);

}  // namespace impetus::inline drawing
