// SPDX-License-Identifier: MIT
#include "experiments/session/gaze_latency.hpp"

#include <algorithm>
#include <cmath>

namespace impetus {

std::optional<double> gaze_latency_p95_ms(const std::vector<StepRecord>& steps,
                                          const std::vector<FrameRecord>& frames) {
  std::vector<double> latencies_ms;
  for (const StepRecord& step : steps) {
    if (step.gaze.fixation && step.shown_frame >= 0) {
      const Flip& flip = frames[static_cast<std::size_t>(step.shown_frame)].flip;
      latencies_ms.push_back(static_cast<double>(flip.flipped_ns - step.gaze.taken_ns) / 1e6);
    }
  }
  if (latencies_ms.empty()) {
    return std::nullopt;
  }
  const double rank = std::ceil(0.95 * static_cast<double>(latencies_ms.size()));
  const auto place = latencies_ms.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::nth_element(latencies_ms.begin(), place, latencies_ms.end());
  return *place;
}

}  // namespace impetus
