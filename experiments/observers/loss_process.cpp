// SPDX-License-Identifier: MIT
#include "experiments/observers/loss_process.hpp"

namespace impetus::inline observers {

LossProcess::LossProcess(RandomStream stream, double per_s, double mean_ms, std::int64_t start_ns)
    : stream_(stream), per_s_(per_s), mean_ms_(mean_ms), to_ns_(static_cast<double>(start_ns)) {
  draw_next();
}

void LossProcess::draw_next() {
  from_ns_ = to_ns_ + 1e9 * draw_waiting(stream_, per_s_);
  to_ns_ = from_ns_ + 1e6 * draw_between(stream_, 0.5 * mean_ms_, 1.5 * mean_ms_);
}

bool LossProcess::lost_at(std::int64_t instant_ns) {
  const auto instant = static_cast<double>(instant_ns);
  while (to_ns_ <= instant) {
    draw_next();
  }
  return from_ns_ <= instant;
}

}  // namespace impetus::inline observers
