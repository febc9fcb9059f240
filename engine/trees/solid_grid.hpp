// A solid and the nodes of a tree on one grid of cell centres: what their volumes share.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// The volume of the union of `volumes` outside `solid` (m³), by the cells of a grid over the
/// bounds of the union, `divisions` along the longest side. Cells count by their centres.
/// Precondition: find_defects(solid).none(), one volume or more.
double outside_volume_m3(const TriangleMesh& solid, const std::vector<Volume>& volumes,
                         int divisions);

}  // namespace impetus::inline trees
