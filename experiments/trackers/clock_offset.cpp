// SPDX-License-Identifier: MIT
#include "experiments/trackers/clock_offset.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace impetus::inline trackers {
namespace {

std::int64_t drift_ns(std::int64_t since_ns, std::int64_t now_ns) {
  return std::llround(kDrift * static_cast<double>(now_ns - since_ns));
}

}  // namespace

std::optional<std::int64_t> nanoseconds(double remote_s) {
  constexpr double kMost_s = 4e9;  // the year 2096 of a clock that counts from 1970
  if (!(std::abs(remote_s) <= kMost_s)) {
    return std::nullopt;
  }
  return std::llround(remote_s * 1e9);
}

void RoundTripOffset::add(std::int64_t sent_ns, std::int64_t remote_ns, std::int64_t received_ns) {
  const std::int64_t error_ns = (received_ns - sent_ns + 1) / 2;
  const std::int64_t offset_ns = sent_ns + (received_ns - sent_ns) / 2 - remote_ns;
  const std::int64_t aged_ns = estimate_.error_ns + drift_ns(estimated_ns_, received_ns);
  const bool contradicts = std::abs(offset_ns - estimate_.offset_ns) > error_ns + aged_ns;
  if (!known_ || error_ns <= aged_ns || contradicts) {
    estimate_ = {offset_ns, error_ns};
    estimated_ns_ = received_ns;
    known_ = true;
  }
}

void OneWayOffset::add(std::int64_t remote_ns, std::int64_t arrived_ns) {
  constexpr std::size_t kRecent = 256;
  const std::int64_t offset_ns = arrived_ns - remote_ns;
  if (!is_known() || offset_ns <= offset_ns_ + drift_ns(estimated_ns_, arrived_ns)) {
    offset_ns_ = offset_ns;
    estimated_ns_ = arrived_ns;
  }
  if (recent_ns_.size() < kRecent) {
    recent_ns_.push_back(offset_ns);
  } else {
    recent_ns_[next_] = offset_ns;
  }
  next_ = (next_ + 1) % kRecent;
}

ClockEstimate OneWayOffset::estimate() const {
  std::vector<std::int64_t> sorted = recent_ns_;
  std::sort(sorted.begin(), sorted.end());
  const std::int64_t late_ns = sorted.empty() ? offset_ns_ : sorted[(sorted.size() - 1) * 95 / 100];
  return {offset_ns_, std::max<std::int64_t>(0, late_ns - offset_ns_), true};
}

}  // namespace impetus::inline trackers
