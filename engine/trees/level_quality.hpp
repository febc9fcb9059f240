// How tightly each level of a volume tree fits the solid it bounds.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/tree_settings.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus {

struct LevelQuality {
  std::int32_t nodes{0};
  double worst_protrusion_m{0.0};
  double mean_protrusion_m{0.0};
  double outside_ratio{0.0};
  double largest_node_m{0.0};
  std::size_t bytes{0};
  double uncovered_area_m2{0.0};
};

/// One per level of the tree.
std::vector<LevelQuality> measure_levels(const TriangleMesh& solid, const VolumeTree& tree,
                                         const Progress& progress = {});

}  // namespace impetus
