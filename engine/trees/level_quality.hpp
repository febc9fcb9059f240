// How well each level of a volume tree stands for its solid: how far it reaches beyond, how much of
// it lies outside, and what of the surface it leaves bare.
//
//   worst   ................   sup over the union of the distance to the solid, a certified bound
//   mean         ..            the same distance averaged over the surface of the union
//   outside    ......          volume of union ∖ solid over the volume of the solid
//
// Every sample is placed by fixed sequences and grids, so a tree has the same numbers everywhere.
// (The measures of Bradshaw and O'Sullivan 2004, with bounds and proofs in place of samples where
// a level is promised to bound.)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/tree_settings.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// All of it is of the nodes that stand for the object at the level (VolumeTree::standing_at), but
/// for `bytes`.
struct LevelQuality {
  std::int32_t nodes{0};  ///< standing at the level
  /// One-sided Hausdorff distance from the union of the nodes to the solid: an upper bound, at most
  /// kFitTolerance (see fit_error.hpp) above the truth unless the work for it ran out.
  double worst_protrusion_m{0.0};
  /// Distance outside the solid, 0 inside, averaged over the surface of the union: a few thousand
  /// samples, so within about 2% of the truth.
  double mean_protrusion_m{0.0};
  /// Volume of union ∖ solid over the solid's own, by the centres of a grid of 128 cells along the
  /// longest side of the tree's bounds: within about 1% of the solid's volume.
  double outside_ratio{0.0};
  double largest_node_m{0.0};  ///< the greatest diameter of a bounding sphere
  std::size_t bytes{0};        ///< of the nodes stored in this level, whatever stands from before
  double uncovered_area_m2{0.0};  ///< of the solid's surface: see coverage.hpp
};

/// One entry per level of `tree`, which is in the frame of `solid`. Precondition:
/// find_defects(solid).none(), one triangle or more.
std::vector<LevelQuality> measure_levels(const TriangleMesh& solid, const VolumeTree& tree,
                                         const Progress& progress = {});

}  // namespace impetus::inline trees
