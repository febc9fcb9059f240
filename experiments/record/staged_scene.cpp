// SPDX-License-Identifier: MIT
#include "experiments/record/staged_scene.hpp"

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline record {

Viewer turned_viewer(const Viewer& start, const ViewerTurn& turn, double time_s) {
  if (turn.rate_deg_s == 0.0) {
    return start;
  }
  Viewer viewer =
      viewer_at(start.screen, turn.azimuth_deg + turn.rate_deg_s * time_s, turn.elevation_deg);
  viewer.turning = Vector3(0.0, kRadiansPerDegree * turn.rate_deg_s, 0.0);
  viewer.velocity = viewer.turning.cross(viewer.eye);
  return viewer;
}

std::vector<std::string> body_names(const World& world) {
  std::vector<std::string> names;
  for (const BodyModel& body : world.models()) {
    names.push_back(body.name);
  }
  return names;
}

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
