// Solids with plane faces: the box, and the L-block, two arms of square section that share a
// corner, the concave body of the studies.
//
//   y ^  +--+
//     |  |  |
//     |  |  +-----+   thickness_m
//     |  +--------+
//     +----------------> x        extruded along z by thickness_m
//        <- arm_m ->
//
// (Dingliana 2002, sec. 6.2.2)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 12 outward triangles about the origin; `sides_m` positive.
TriangleMesh box_mesh(const Vector3& sides_m);

/// 20 outward triangles and no face inside; the outer corner at the origin, z from −½ to +½ of the
/// thickness. Precondition: 0 < thickness_m < arm_m. about_centre_of_mass() gives a body's frame.
TriangleMesh l_block_mesh(double arm_m, double thickness_m);

}  // namespace impetus::inline shapes
