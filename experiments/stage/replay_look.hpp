// What the viewer of replays shows, as its keys have it: kept from one trial to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/orbit_camera.hpp"
#include "experiments/stage/body_colours.hpp"

namespace impetus {

struct ReplayLook {
  bool gaze{true};
  bool contacts{false};
  bool volumes{false};
  bool finest{false};  ///< beside it
  BodyColours colours{BodyColours::kOwn};
  OrbitCamera camera;
};

}  // namespace impetus
