// Plays recorded stimuli, one after the other: forwards, backwards, step by step, slowly, by the
// timeline; from anywhere, with what collision handling did, beside the same at the finest level.
//
//   title, facts
//   +--------------------+ +--------------------+
//   | as recorded        | | at the finest level|     the second where it is asked for
//   +--------------------+ +--------------------+
//   state, buttons, timeline
//
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/viewing/viewed_stimuli.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline viewers {

/// Shows them, from the first on, until the window is closed. `clock` is the window's.
void view_replays(Window& window, ViewedStimuli& stimuli, const Clock& clock);

}  // namespace impetus::inline viewers
