// What the viewer's commands do to where a replay stands.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "experiments/viewers/replays/replay_commands.hpp"
#include "experiments/viewing/replay_playback.hpp"

namespace impetus::inline viewers {

/// Plays, steps, jumps and changes speed. None: the command is about something else; otherwise what
/// is to be said, such as that there is no later collision, or "".
std::optional<std::string> steer(ReplayPlayback& playback, const ReplayView& replay,
                                 ReplayCommand command);

}  // namespace impetus::inline viewers
