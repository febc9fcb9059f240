// One attempt at a trial: interval, one stimulus or two, questions.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/questions/script.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline session {

/// The interfaces a session runs on; all must outlive it.
struct Ports {
  Display& display;
  Input& input;
  const Scenes& scenes;
  Recorder& recorder;
  Gaze* gaze{nullptr};               ///< none: gaze is not followed
  const Clock* clock{nullptr};       ///< of the gaze's samples; needed with it
  const Clock* work_clock{nullptr};  ///< real time; needed by scenes with a budget in milliseconds
  const GazePaths* gaze_paths{nullptr};  ///< of the trials that regions are yoked to
  GazeCorrection gaze_correction{};      ///< by the last calibration
  /// Says a sentence to the experimenter while the session runs; none: nobody is there to hear it.
  std::function<void(const std::string&)> tell{};
  Markers* markers{nullptr};  ///< none: nothing is marked
  Sounds* sounds{nullptr};    ///< none: nothing is heard, and nothing recorded of it
};

/// An attempt's record, and what interrupted it.
struct AttemptResult {
  AttemptRecord record;
  Interruption interruption{Interruption::kNone};
};

/// Shows the interval (during which the trial before is being saved), waits until it is saved,
/// then shows fixation and stimulus (where two intervals are asked for, both, with a blank between)
/// and asks the script's questions. Each frame shows the state for its scheduled time, so every
/// participant sees the same frames. Where the script asks for it, clicks are kept and the gaze is
/// followed during the stimulus; where markers go to another recorder, they are told right after
/// the flip. A trial that `may_be_repeated` ends before its questions when too much of the gaze was
/// lost, interrupted by kGazeLostNote. Throws what the recorder throws.
AttemptResult run_attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
                          const SessionProgress& progress, const Ports& ports,
                          bool may_be_repeated = false);

}  // namespace impetus::inline session
