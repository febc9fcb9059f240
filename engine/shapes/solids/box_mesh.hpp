// A box as a closed triangle mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// 12 outward triangles about the origin; `sides_m` positive.
TriangleMesh box_mesh(const Vector3& sides_m);

}  // namespace impetus::inline shapes
