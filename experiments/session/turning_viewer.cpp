// SPDX-License-Identifier: MIT
#include "experiments/session/turning_viewer.hpp"

namespace impetus {

Viewer turned_viewer(const Viewer& start, const ViewerTurn& turn, double time_s) {
  constexpr double kRadiansPerDegree = 0.017453292519943295;
  if (turn.rate_deg_s == 0.0) {
    return start;
  }
  Viewer viewer = viewer_at(start.screen, turn.azimuth_deg + turn.rate_deg_s * time_s);
  viewer.turning = Vector3(0.0, kRadiansPerDegree * turn.rate_deg_s, 0.0);
  viewer.velocity = viewer.turning.cross(viewer.eye);
  return viewer;
}

}  // namespace impetus
