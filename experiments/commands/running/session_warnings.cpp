// SPDX-License-Identifier: MIT
#include "experiments/commands/running/session_warnings.hpp"

#include <cstdio>

#include "experiments/gaze/gaze_latency.hpp"

namespace impetus::inline commands {
namespace {

void tell_late_frames(const FrameCount& frames) {
  if (frames.late > 0) {
    std::fprintf(
        stderr,
        "warning: %lld of %lld timed frames were late (trials with any: %lld); each is stored\n",
        static_cast<long long>(frames.late), static_cast<long long>(frames.timed),
        static_cast<long long>(frames.late_attempts));
  }
}

void tell_gaze_latency(const GazeTroubles& gaze) {
  if (gaze.slow_trials > 0) {
    std::fprintf(
        stderr,
        "warning: trials with more than %.0f ms from gaze sample to flip (95th percentile): "
        "%lld; of them with more than %.0f ms, and marked: %lld\n",
        kWarnedGazeLatency_ms, static_cast<long long>(gaze.slow_trials), kMarkedGazeLatency_ms,
        static_cast<long long>(gaze.late_trials));
  }
}

void tell_lost_gaze(const GazeTroubles& gaze) {
  if (gaze.lost_trials + gaze.repeated_trials > 0) {
    std::fprintf(
        stderr,
        "warning: trials marked because too much of the gaze was lost: %lld; shown again for "
        "that: %lld\n",
        static_cast<long long>(gaze.lost_trials), static_cast<long long>(gaze.repeated_trials));
  }
}

}  // namespace

void tell_not_finite(const StudyWriter& writer) {
  if (writer.not_finite_attempts() > 0) {
    std::fprintf(stderr,
                 "warning: in %lld trials the state of a body was no longer a finite number; it "
                 "was taken out, and the study's notes name it\n",
                 static_cast<long long>(writer.not_finite_attempts()));
  }
}

void tell_warnings(const SessionResult& result, const StudyWriter& writer) {
  tell_late_frames(writer.frames());
  tell_gaze_latency(result.gaze);
  tell_lost_gaze(result.gaze);
  tell_not_finite(writer);
}

}  // namespace impetus::inline commands
