// A sphere as a closed triangle mesh: an icosahedron whose triangles are split into four.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 20 · 4^subdivisions outward triangles with their vertices on the sphere of `radius_m` about the
/// origin; `subdivisions` from 0 to 7.
TriangleMesh icosphere_mesh(double radius_m, int subdivisions);

}  // namespace impetus::inline shapes
