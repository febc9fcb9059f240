// What the viewer of replays shows, as its keys have it: kept from one trial to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/body_colours.hpp"
#include "experiments/viewers/replays/replay_commands.hpp"
#include "experiments/viewing/orbit_camera.hpp"

namespace impetus::inline viewers {

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

}  // namespace impetus::inline viewers
