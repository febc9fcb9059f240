// SPDX-License-Identifier: MIT
#include "experiments/gaze/recorded_gaze.hpp"

namespace impetus::inline gaze {

void RecordedGaze::shown(const Picture& picture, const Flip& flip) {
  if (!onset_ns_ && !picture.bodies.empty()) {
    onset_ns_ = flip.flipped_ns;
  }
}

std::vector<GazeSample> RecordedGaze::take_samples() {
  std::vector<GazeSample> due;
  while (onset_ns_ && next_ < samples_.size()) {
    GazeSample sample = samples_[next_];
    sample.taken_ns += *onset_ns_ - then_ns_;
    if (sample.taken_ns > clock_.now_ns()) {
      break;
    }
    due.push_back(sample);
    ++next_;
  }
  return due;
}

}  // namespace impetus::inline gaze
