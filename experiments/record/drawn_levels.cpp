// SPDX-License-Identifier: MIT
#include "experiments/record/drawn_levels.hpp"

namespace impetus::inline record {

const std::shared_ptr<const TriangleMesh>& mesh_as_seen(
    const std::shared_ptr<const TriangleMesh>& mesh, const DrawnLevels* coarser,
    double px_per_metre) {
  const std::shared_ptr<const TriangleMesh>* chosen = &mesh;
  if (coarser != nullptr) {
    for (const DrawnLevel& level : *coarser) {
      if (level.deviation_m * px_per_metre > kMostDeviation_px) {
        break;
      }
      chosen = &level.mesh;
    }
  }
  return *chosen;
}

}  // namespace impetus::inline record
