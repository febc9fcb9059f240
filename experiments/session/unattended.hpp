// Trials that nobody watches: simulated to their end without a display, and recorded.
//
// Every step's work and hash are kept, so that a replay compares all of them; which body a step
// diverged in cannot be told, for digests of bodies are kept of the start alone: they would be most
// of the file.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "experiments/record/ports.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/session/session_standing.hpp"

namespace impetus::inline session {

/// Plays until `end_s`, or the scene's own end before that. `progress` hears of the share that is
/// done, however many steps it takes.
void play_to(LiveRun& live, double end_s, const std::function<void(double share)>& progress);

/// All trials that `history` lacks, from start to end, each on disk before the next begins; then
/// marks the enrolment as finished. No frame shows them: their onset is 0. `progress` hears of the
/// share that is done. `work_clock` times budgets in milliseconds. Throws what the recorder throws.
void run_unattended(const Plan& plan, const SessionHistory& history, const Scenes& scenes,
                    const ScreenGeometry& screen, Recorder& recorder, const WorkClock& work_clock,
                    const std::function<void(double share)>& progress = {});

}  // namespace impetus::inline session
