// A recorded stimulus on its way to the viewer: its bodies are built and its trial is simulated
// again, behind a screen that says how far that is.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "experiments/viewers/replays/replay_keys.hpp"
#include "experiments/viewing/replay_view.hpp"
#include "experiments/viewing/viewed_stimuli.hpp"
#include "experiments/window/canvas.hpp"

namespace impetus::inline viewers {

/// A stimulus and how it went.
struct LoadedReplay {
  ViewedStimulus stimulus;
  ReplayView view;  ///< complete
};

/// Thrown out of the loading by a key, or when the window was closed.
struct Left {
  ReplayCommand command;  ///< kClose, kPreviousTrial or kNextTrial
};

/// From a recorded stimulus to one that can be viewed. Throws Left.
LoadedReplay load_replay(Canvas& canvas, ViewedStimuli& stimuli, std::size_t index,
                         const Clock& clock);

}  // namespace impetus::inline viewers
