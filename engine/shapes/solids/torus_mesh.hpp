// A ring of round section as a closed triangle mesh; its axis is z.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 2 · segments · sides outward triangles about the origin: `segments` sections along the circle of
/// `radius_m`, each a regular polygon of `sides` corners on the circle of `tube_m`. Preconditions:
/// 0 < tube_m < radius_m; segments, sides ≥ 3.
TriangleMesh torus_mesh(double radius_m, double tube_m, int segments, int sides);

}  // namespace impetus::inline shapes
