// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_look.hpp"

namespace impetus::inline viewers {

bool change_look(ReplayLook& look, ReplayCommand command) {
  switch (command) {
    case ReplayCommand::kGaze:
      look.gaze = !look.gaze;
      return true;
    case ReplayCommand::kContacts:
      look.contacts = !look.contacts;
      return true;
    case ReplayCommand::kVolumes:
      look.volumes = !look.volumes;
      return true;
    case ReplayCommand::kColours:
      look.colours = next_colours(look.colours);
      return true;
    case ReplayCommand::kFinest:
      look.finest = !look.finest;
      return true;
    case ReplayCommand::kOwnView:
      look.camera.reset();
      return true;
    default:
      return false;
  }
}

}  // namespace impetus::inline viewers
