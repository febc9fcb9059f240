// What the viewer of replays shows, as its keys have it: kept from one trial to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/orbit_camera.hpp"
#include "experiments/stage/body_colours.hpp"
#include "experiments/stage/replay_commands.hpp"

namespace impetus {

struct ReplayLook {
  bool gaze{true};
  bool contacts{false};
  bool volumes{false};
  bool finest{false};  ///< beside it
  BodyColours colours{BodyColours::kOwn};
  OrbitCamera camera;
};

/// Does what a command asks of it; false: it is about something else.
bool change_look(ReplayLook& look, ReplayCommand command);

}  // namespace impetus
