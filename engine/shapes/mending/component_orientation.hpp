// Which way round the components of a closed mesh must be for it to bound a solid.
//
//   +-----------+   A component inside an even number of others is a body and looks outward; inside
//   | +---+     |   an odd number it is a cavity and looks inward. Then every point is inside once
//   | |   | -->-|-> or not at all.
//   | +---+     |
//   +-----------+
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/mesh_components.hpp"

namespace impetus::inline shapes {

struct ComponentOrientation {
  std::vector<bool> flat;    ///< encloses no more than the rounding of its coordinates
  std::vector<bool> turned;  ///< a body that looks inward or a cavity that looks outward
};

/// One entry for each component. Thickness is volume over area: a component thinner than 2^-22 of
/// its diagonal is flat, as single-precision coordinates are rounded by 2^-24. One component counts
/// as inside another when its box is and sixteen of its vertices are. Precondition:
/// find_defects(mesh).none().
ComponentOrientation orientation_of(const TriangleMesh& mesh, const MeshComponents& components);

}  // namespace impetus::inline shapes
