// A four-legged animal with a long neck, two horns and a raised tail, in mid-stride: the concave,
// recognisable body of the scenes, made without a file.
//
//   tail              _/ horns      One connected solid: round cones about the bones, blended
//     \__    ______  / \_  snout    where they meet, and the level set of what results.
//        \__/      \/
//           /|    |\            x forward, y up, z to its right
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// A closed outward mesh that is `length_m` long along x, about the middle of the trunk. Its
/// triangles lie on a grid of `cells` along that length and number about 11 · cells². Precondition:
/// `cells` a multiple of 4 from 8 to 48; fewer than 16 may join the feet or part a horn.
TriangleMesh creature_mesh(double length_m, int cells);

}  // namespace impetus::inline shapes
