// Boxes: of any sides and orientation, and the cube of a voxel tree.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/vector.hpp"

namespace impetus {

/// The points centre + R x with |x_i| ≤ half_extents_m[i], R the matrix of `orientation` (unit).
struct Box {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_extents_m{Vector3::Zero()};
  Quaternion orientation{Quaternion::Identity()};
};

/// A box of equal sides. Its contacts are those of the sphere that circumscribes it (Dingliana
/// 2002, sec. 4.1.2); its overlaps are its own.
struct Cube {
  Vector3 centre{Vector3::Zero()};
  double half_edge_m{0.0};
  Quaternion orientation{Quaternion::Identity()};
};

}  // namespace impetus
