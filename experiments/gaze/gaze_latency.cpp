// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_latency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impetus::inline gaze {
namespace {

/// Whether the sample after the one used was lost by the time of the step, and not just the mark
/// that there are none.
bool eye_was_lost(const GazeInput& gaze, const std::vector<GazeSample>& samples) {
  const auto next = std::upper_bound(
      samples.begin(), samples.end(), gaze.taken_ns,
      [](std::int64_t taken_ns, const GazeSample& sample) { return taken_ns < sample.taken_ns; });
  return next != samples.end() && next->loss != GazeLoss::kNone &&
         next->taken_ns > gaze.taken_ns + kSilentAfter_ns &&
         next->taken_ns <= gaze.taken_ns + gaze.age_ns;
}

/// The least value that at least this share of the values does not exceed.
double nearest_rank(std::vector<double> values, double share) {
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::vector<double> gaze_latencies_ms(const std::vector<StepRecord>& steps,
                                      const std::vector<FrameRecord>& frames,
                                      const std::vector<GazeSample>& samples) {
  std::vector<double> latencies_ms;
  for (const StepRecord& step : steps) {
    if (step.gaze.fixation && step.shown_frame >= 0 && !eye_was_lost(step.gaze, samples)) {
      const Flip& flip = frames[static_cast<std::size_t>(step.shown_frame)].flip;
      latencies_ms.push_back(static_cast<double>(flip.flipped_ns - step.gaze.taken_ns) / 1e6);
    }
  }
  return latencies_ms;
}

std::optional<double> gaze_latency_p95_ms(const std::vector<StepRecord>& steps,
                                          const std::vector<FrameRecord>& frames,
                                          const std::vector<GazeSample>& samples) {
  std::vector<double> latencies_ms = gaze_latencies_ms(steps, frames, samples);
  if (latencies_ms.empty()) {
    return std::nullopt;
  }
  return nearest_rank(std::move(latencies_ms), 0.95);
}

}  // namespace impetus::inline gaze
