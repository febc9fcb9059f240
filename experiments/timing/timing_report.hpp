// All that a timing report tells, measured values and raw ones, as plain data.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/session/timing_check.hpp"
#include "experiments/timing/content_check.hpp"
#include "experiments/timing/flip_statistics.hpp"
#include "experiments/timing/input_delay.hpp"

namespace impetus::inline timing {

/// One run of flips on an absolute grid.
struct FlipSeries {
  int bodies{0};  ///< simulated and drawn; 0: a blank picture
  FlipStatistics statistics;
  std::vector<double> intervals_ms;        ///< raw, one fewer than flips
  std::vector<std::int64_t> missed_slots;  ///< raw, one per flip
};

/// From the gaze sample that decided a step to the flip that first showed the step.
struct GazeRun {
  std::string source;
  std::vector<double> latencies_ms;  ///< raw, one per step that was shown and knew the gaze
  double lost_share{0.0};            ///< of the run, time without a valid sample
};

struct ContentRun {
  std::string corner;
  bool readable{false};  ///< false: the window system cannot be asked for what it shows
  ContentCheck check;
};

struct TimingFacts {
  std::string build;
  std::string machine;
  std::string started_utc;
  std::string display;     ///< driver, renderer, size, refresh, what a stamp is anchored to
  std::string compositor;  ///< "none", "running" or "not known"
  int width_px{0};
  int height_px{0};
  double nominal_hz{0.0};
  double seconds{0.0};  ///< that each part took
};

struct TimingReport {
  TimingFacts facts;
  SyncTest sync;
  std::vector<FlipSeries> runs;  ///< the first is of a blank picture
  std::vector<InputDelay> inputs;
  GazeRun gaze;
  ContentRun content;
};

inline constexpr double kPromptGaze_ms = 40.0;  ///< shares of the gaze's latencies are told above
inline constexpr double kLateGaze_ms = 80.0;    ///< this one and this one

}  // namespace impetus::inline timing
