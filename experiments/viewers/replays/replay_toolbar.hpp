// The buttons of the viewer of replays, each with its key: one row that moves, one that shows.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/viewers/replays/replay_commands.hpp"
#include "experiments/viewers/replays/replay_look.hpp"
#include "experiments/viewing/replay_playback.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline viewers {

/// What the two rows take, in pixels.
[[nodiscard]] float toolbar_height(const Gui& gui);

/// Draws them from the cursor down, at most `width_px` wide. Jumps that `marks` have no aim for are
/// left out. Returns the command that was clicked.
std::optional<ReplayCommand> draw_toolbar(const Gui& gui, const ReplayPlayback& playback,
                                          const std::vector<TimelineMark>& marks,
                                          const ReplayLook& look, float width_px);

}  // namespace impetus::inline viewers
