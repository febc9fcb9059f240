// Every kind of volume as one shape to draw: a box whose edges are rounded.
//
//   half extents   0 0 0   a 0 0    a b 0       a b c
//   radius         r       r        r           0
//   volume         sphere  line-    rectangle-  box, cube
//                          swept    swept
//
// Its mesh is a sphere cut in eight along its axes, the pieces moved to the corners of the box, and
// the gaps closed by strips and faces: one mesh, stretched for each volume as it is drawn.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/volumes/volume.hpp"

namespace impetus {

/// All points within radius_m of centre + R x with |x_i| ≤ half_extents_m[i].
struct RoundedBox {
  Vector3 centre{Vector3::Zero()};
  Quaternion orientation{Quaternion::Identity()};
  Vector3 half_extents_m{Vector3::Zero()};
  double radius_m{0.0};
};

/// The same points as the volume's.
RoundedBox rounded_box(const Volume& volume);

/// In the world, of a body at `pose`.
RoundedBox posed(const RoundedBox& box, const Pose& pose);

struct RoundedBoxMesh {
  /// A vertex lies at centre + R (corner ∘ half_extents_m + radius_m · normal), with normal R n.
  struct Vertex {
    std::array<float, 3> corner;  ///< ±1 each
    std::array<float, 3> normal;  ///< unit
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise from outside
};

/// `parts` ≥ 1: into how many a quarter of a great circle is cut.
RoundedBoxMesh rounded_box_mesh(int parts);

}  // namespace impetus
