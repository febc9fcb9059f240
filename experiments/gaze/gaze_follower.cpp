// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_follower.hpp"

namespace impetus::inline gaze {

void GazeFollower::begin(std::int64_t extra_latency_ns) {
  extra_latency_ns_ = extra_latency_ns;
  look();
  samples_.clear();
}

GazeInput GazeFollower::look() {
  if (gaze_ == nullptr) {
    return {};
  }
  for (const GazeSample& sample : gaze_->take_samples()) {
    samples_.push_back(sample);
    if (sample.at) {
      waiting_.push_back(sample);
    }
  }
  const std::int64_t now_ns = clock_->now_ns();
  while (!waiting_.empty() && now_ns - waiting_.front().taken_ns >= extra_latency_ns_) {
    used_ = waiting_.front();
    waiting_.pop_front();
  }
  if (!used_.at) {
    return {};
  }
  return {correction_.corrected(used_.at), used_.taken_ns, now_ns - used_.taken_ns, {}};
}

}  // namespace impetus::inline gaze
