// Shares a part of a surface among spheres: each gets what is nearest to it by power distance.
//
//   power of a point to a sphere = distance to its centre, squared − radius²
//
// Cells are bounded by planes, so the pieces are cut exactly; where spheres cover a point, its
// cell's sphere does. (Aurenhammer 1987)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/trees/surface_part.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {

/// The piece of `part` in the power cell of each sphere, empty ones too. The pieces tile the part.
std::vector<SurfacePart> power_cells(SurfacePart part, const std::vector<Sphere>& spheres);

/// The index of the sphere to which `point` has the least power. Precondition: one or more spheres.
std::size_t least_power(const std::vector<Sphere>& spheres, const Vector3& point);

}  // namespace impetus::inline trees
