// Makes a closed, outward surface of a mesh with small defects, and counts every change.
//
//   weld (when open) -> drop degenerate and duplicate -> orient alike -> fill holes -> orient
//   outward
//
// Nothing is guessed: an edge of three triangles, a one-sided surface or a large hole ends it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/shapes/mending/hole_filling.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// Vertices nearer than this part of the bounding box's diagonal become one.
inline constexpr double kWeldingDistance = 1e-6;

/// What ended a repair before the surface was closed.
enum class RepairObstacle {
  kNone,
  kNothingLeft,   ///< no triangle has an area
  kCrowdedEdges,  ///< `obstacles` edges have more than two triangles
  kOneSided,      ///< the surface has one side only, like a Möbius strip
  kLargeHoles,    ///< `obstacles` holes of more than kLargestHole edges
  kStuckHoles,    ///< `obstacles` holes that nothing closes without a new defect
};

/// The mended mesh, and what was done to it.
struct MeshRepair {
  TriangleMesh mesh;                   ///< as far as the repair came; no unused vertices
  std::int64_t vertices_welded{0};     ///< vertices that another now stands for
  std::int64_t degenerate_dropped{0};  ///< triangles
  std::int64_t duplicate_dropped{0};   ///< triangles
  std::int64_t triangles_turned{0};    ///< to agree with their neighbours
  HoleFilling filling;
  std::int64_t components_turned{0};  ///< bodies that looked inward, cavities that looked outward
  RepairObstacle obstacle{RepairObstacle::kNone};
  std::int64_t obstacles{0};  ///< how many, where that says something

  [[nodiscard]] bool changed() const {
    return vertices_welded + degenerate_dropped + duplicate_dropped + triangles_turned +
               filling.holes + components_turned >
           0;
  }
};

/// Repairs a mesh with finite vertices whose indices are within `mesh.vertices`. Without an
/// obstacle find_defects() finds nothing in the result but, perhaps, flat components.
MeshRepair repair(TriangleMesh mesh);

}  // namespace impetus::inline shapes
