// One run through points of the screen that are to be looked at, and the gaze meanwhile.
//
//   point 1  |---settle---|--count--| point 2 |---settle---|--count--| ...      one display grid
//
// The first half of each point is for finding it. Samples are given to points by their own stamps,
// so that it does not matter how late they come.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/gaze/gaze_quality.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

struct PointRun {
  std::vector<PointSamples> points;   ///< in the order shown; raw samples, of the halves that count
  std::optional<double> sampling_hz;  ///< over the whole run
  std::int64_t began_ns{0};
  Interruption interruption{Interruption::kNone};  ///< other than kNone: the run is not whole
};

/// Shows each of `points` for `point_ms`. `ports` must have a gaze.
PointRun run_points(const std::vector<ScreenPoint>& points, double point_ms,
                    const SessionProgress& progress, const Ports& ports);

/// Nine points, three by three, over `share` of the screen's width and height, row by row.
std::vector<ScreenPoint> nine_points(const ScreenGeometry& screen, double share);

/// The run with every sample corrected.
PointRun corrected(PointRun run, const GazeCorrection& correction);

}  // namespace impetus::inline session
