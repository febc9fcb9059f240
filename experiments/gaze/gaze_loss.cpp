// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_loss.hpp"

#include <algorithm>

namespace impetus::inline gaze {

std::optional<double> gaze_lost_share(const std::vector<GazeSample>& samples, std::int64_t from_ns,
                                      std::int64_t until_ns) {
  if (until_ns <= from_ns) {
    return std::nullopt;
  }
  std::int64_t known_ns = 0;
  const auto know = [&](std::int64_t since_ns, std::int64_t to_ns) {
    known_ns += std::max<std::int64_t>(0, std::min(to_ns, until_ns) - std::max(since_ns, from_ns));
  };
  if (!samples.empty() && samples.front().at) {
    // Nothing is kept from before the stimulus: the first one tells of the time just before it.
    know(samples.front().taken_ns - kGazeHolds_ns, samples.front().taken_ns);
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].at) {
      const std::int64_t next_ns = i + 1 < samples.size() ? samples[i + 1].taken_ns : until_ns;
      know(samples[i].taken_ns, std::min(next_ns, samples[i].taken_ns + kGazeHolds_ns));
    }
  }
  return 1.0 - static_cast<double>(known_ns) / static_cast<double>(until_ns - from_ns);
}

bool gaze_was_lost(const std::optional<GazeLossRule>& rule, std::optional<double> lost_share) {
  return rule && rule->policy != GazeLossRule::Policy::kKeep &&
         lost_share.value_or(0.0) > rule->most_lost_share;
}

std::int64_t most_repeats(const std::optional<GazeLossRule>& rule) {
  return rule && rule->policy == GazeLossRule::Policy::kRepeat ? rule->most_repeats : 0;
}

}  // namespace impetus::inline gaze
