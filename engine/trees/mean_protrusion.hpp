// How far the surface of a union of volumes lies from a solid on average.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/shapes/surface_distance.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// Distance to the solid (metres; 0 inside) averaged over the surface of the union of `volumes`, by
/// about `samples` points spread evenly over the volumes' surfaces; those within another volume are
/// not of the union's.
double mean_protrusion_m(const std::vector<Volume>& volumes, const SurfaceDistance& solid,
                         int samples);

}  // namespace impetus::inline trees
