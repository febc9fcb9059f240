// SPDX-License-Identifier: MIT
#include "engine/trees/level_quality.hpp"

#include <algorithm>

namespace impetus {

std::vector<LevelQuality> measure_levels(const TriangleMesh& solid, const VolumeTree& tree,
                                         const Progress& progress) {
  static_cast<void>(solid);
  std::vector<LevelQuality> levels;
  for (int level = 0; level < tree.level_count(); ++level) {
    LevelQuality quality;
    for (const std::int32_t node : tree.standing_at(level)) {
      ++quality.nodes;
      quality.largest_node_m =
          std::max(quality.largest_node_m, 2.0 * bounding_sphere(tree.volume(node)).radius_m);
    }
    quality.worst_protrusion_m = tree.fit_error_m(level);
    quality.bytes = static_cast<std::size_t>(quality.nodes) *
                    (tree.bytes() / static_cast<std::size_t>(tree.node_count()));
    levels.push_back(quality);
    if (progress) {
      progress((level + 1.0) / tree.level_count());
    }
  }
  return levels;
}

}  // namespace impetus
