// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_trail.hpp"

#include <algorithm>

namespace impetus::inline gaze {

std::vector<TimedGaze> timed_gaze(const std::vector<GazeSample>& samples,
                                  const GazeCorrection& correction, std::int64_t interval,
                                  std::int64_t onset_ns) {
  std::vector<TimedGaze> gaze;
  for (const GazeSample& sample : samples) {
    if (sample.interval == interval) {
      gaze.push_back({static_cast<double>(sample.taken_ns - onset_ns) / 1e9,
                      correction.corrected(sample.at), sample.loss});
    }
  }
  return gaze;
}

GazeTrail trail_at(const std::vector<TimedGaze>& gaze, double time_s) {
  const auto later = [](double time, const TimedGaze& sample) { return time < sample.time_s; };
  const auto first = std::upper_bound(gaze.begin(), gaze.end(), time_s - kTrail_s, later);
  const auto end = std::upper_bound(first, gaze.end(), time_s, later);
  GazeTrail trail;
  bool joined = false;
  for (auto sample = first; sample != end; ++sample) {
    if (sample->at) {
      trail.points.push_back({*sample->at, time_s - sample->time_s, joined});
    }
    joined = sample->at.has_value();
    trail.lost = sample->loss;
  }
  return trail;
}

std::vector<LostStretch> lost_stretches(const std::vector<TimedGaze>& gaze) {
  std::vector<LostStretch> stretches;
  bool lost = false;
  for (const TimedGaze& sample : gaze) {
    if (lost) {
      stretches.back().end_s = sample.time_s;
    } else if (!sample.at) {
      stretches.push_back({sample.time_s, sample.time_s, sample.loss});
    }
    lost = !sample.at;
  }
  return stretches;
}

const char* word_of(GazeLoss loss) {
  switch (loss) {
    case GazeLoss::kBlink:
      return "blink";
    case GazeLoss::kOffScreen:
      return "gaze off screen";
    case GazeLoss::kLost:
      return "gaze lost";
    case GazeLoss::kNone:
      break;
  }
  return "";
}

}  // namespace impetus::inline gaze
