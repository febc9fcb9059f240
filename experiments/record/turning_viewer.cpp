// SPDX-License-Identifier: MIT
#include "experiments/record/turning_viewer.hpp"

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline record {

Viewer turned_viewer(const Viewer& start, const ViewerTurn& turn, double time_s) {
  if (turn.rate_deg_s == 0.0) {
    return start;
  }
  Viewer viewer = viewer_at(start.screen, turn.azimuth_deg + turn.rate_deg_s * time_s);
  viewer.turning = Vector3(0.0, kRadiansPerDegree * turn.rate_deg_s, 0.0);
  viewer.velocity = viewer.turning.cross(viewer.eye);
  return viewer;
}

}  // namespace impetus::inline record
