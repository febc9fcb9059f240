// The gaze of a recorded stimulus over the last moments, and where it was lost.
//
//   samples   v v v x x v v v
//   trail     o-o-o     o-o-O      joined where nothing was lost between; the last is the newest
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/gaze.hpp"
#include "experiments/record/gaze_correction.hpp"

namespace impetus::inline gaze {

inline constexpr double kTrail_s = 0.3;

/// A sample as a replay shows it: corrected by the calibration, timed from the stimulus's onset.
struct TimedGaze {
  double time_s{0.0};
  Fixation at{};  ///< none: lost
  GazeLoss loss{GazeLoss::kNone};
};

/// Those of one interval, in order.
std::vector<TimedGaze> timed_gaze(const std::vector<GazeSample>& samples,
                                  const GazeCorrection& correction, std::int64_t interval,
                                  std::int64_t onset_ns);

/// A place that was looked at, and how long ago.
struct TrailPoint {
  ScreenPoint at;
  double age_s{0.0};
  bool joined{false};  ///< to the point before it
};

/// What a replay draws of the gaze at one moment.
struct GazeTrail {
  std::vector<TrailPoint> points;  ///< oldest first
  GazeLoss lost{GazeLoss::kNone};  ///< of the newest sample; kNone: it is valid, or there is none
};

/// What was sampled in the kTrail_s before `time_s`.
GazeTrail trail_at(const std::vector<TimedGaze>& gaze, double time_s);

/// From the first sample of a loss to the next valid one, or to the last sample.
struct LostStretch {
  double begin_s{0.0};
  double end_s{0.0};
  GazeLoss loss{GazeLoss::kLost};  ///< of its first sample
};
std::vector<LostStretch> lost_stretches(const std::vector<TimedGaze>& gaze);

/// "blink", "gaze off screen", "gaze lost"; "" when nothing is.
const char* word_of(GazeLoss loss);

}  // namespace impetus::inline gaze
