// From a recorded stimulus to one that can be viewed: built, simulated again, with a screen that
// says how far it is.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "experiments/viewers/replays/replay_commands.hpp"
#include "experiments/viewing/viewed_stimuli.hpp"
#include "experiments/window/canvas.hpp"

namespace impetus::inline viewers {

struct LoadedReplay {
  ViewedStimulus stimulus;
  ReplayView view;  ///< complete
};

/// Or the key that was pressed instead of waiting: kClose (also when the window was closed),
/// kPreviousTrial or kNextTrial.
using LoadingOutcome = std::variant<LoadedReplay, ReplayCommand>;

/// `clock` says when the screen is due.
LoadingOutcome load_replay(Canvas& canvas, ViewedStimuli& stimuli, std::size_t index,
                           const Clock& clock);

}  // namespace impetus::inline viewers
