// How well the gaze is known, measured while known points were looked at.
//
//   accuracy       mean angle between the samples and the point
//   precision      RMS of the angle from sample to sample; SD about the samples' own mean
//   lost share     of the samples;   sampling rate   as measured, not as promised
//
// (Holmqvist et al. 2012)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/record/record.hpp"

namespace impetus::inline gaze {

/// A point of the screen and the samples taken while it was looked at, in order of time.
struct PointSamples {
  ScreenPoint shown;
  std::vector<GazeSample> samples;
};

/// What the samples of one point say.
CalibrationPointRecord measured(const Viewer& viewer, const PointSamples& point);

/// The points and what they say together: accuracy is the mean over the points that were seen, the
/// precisions are pooled over samples. `passed` when every point was seen and accuracy keeps to
/// `accuracy_limit_deg`.
CalibrationRecord measured(const Viewer& viewer, const std::vector<PointSamples>& points,
                           double accuracy_limit_deg);

/// Samples per second between the first and the last; none of fewer than two.
std::optional<double> sampling_hz_of(const std::vector<GazeSample>& samples);

}  // namespace impetus::inline gaze
