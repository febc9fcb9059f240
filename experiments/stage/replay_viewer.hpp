// Plays one recorded trial: forwards, backwards, step by step, slowly, and by the timeline.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/replay_view.hpp"
#include "experiments/stage/window.hpp"

namespace impetus {

/// Why the viewer was left.
enum class ViewerExit { kClosed, kPreviousTrial, kNextTrial };

/// Shows the trial until it is left. `replay` needs at least one state.
ViewerExit view_replay(Window& window, const ReplayView& replay);

}  // namespace impetus
