// SPDX-License-Identifier: MIT
#include "engine/scheduling/viewer.hpp"

#include "engine/numerics/trigonometry.hpp"

namespace impetus {

Viewer viewer_at(const ScreenGeometry& screen, double azimuth_deg) {
  const SineCosine turn = sine_cosine_deg(azimuth_deg);
  Viewer viewer;
  viewer.screen = screen;
  viewer.eye = screen.viewing_distance_m * Vector3(turn.sine, 0.0, turn.cosine);
  viewer.right = Vector3(turn.cosine, 0.0, -turn.sine);
  return viewer;
}

}  // namespace impetus
