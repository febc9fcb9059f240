// Follows the gaze through a stimulus: keeps every sample, and says where the viewer looks now.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "experiments/record/gaze_correction.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/record/record.hpp"

namespace impetus::inline gaze {

/// One stimulus after another, of one source.
class GazeFollower {
 public:
  /// Without `gaze` nothing is known of it. `clock` is the samples' own. Both must outlive this.
  /// `correction` is done to what is looked at, never to the samples that are kept.
  GazeFollower(Gaze* gaze, const Clock* clock, const GazeCorrection& correction = {})
      : gaze_(gaze), clock_(clock), correction_(correction) {}

  /// Forgets what was sampled before the stimulus, but for where the viewer looked last.
  /// `extra_latency_ns`: samples younger than this are not used yet, a manipulation.
  void begin(std::int64_t extra_latency_ns = 0);

  /// Takes the new samples; the newest valid one that is old enough is where the viewer looks, and
  /// while samples are lost it stays so and ages.
  GazeInput look();

  std::vector<GazeSample> take_samples() { return std::move(samples_); }

 private:
  Gaze* gaze_;
  const Clock* clock_;
  std::int64_t extra_latency_ns_{0};
  GazeCorrection correction_;
  std::deque<GazeSample> waiting_;  ///< valid ones that are too young to be used
  GazeSample used_;
  std::vector<GazeSample> samples_;
};

}  // namespace impetus::inline gaze
