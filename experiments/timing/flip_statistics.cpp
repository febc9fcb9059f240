// SPDX-License-Identifier: MIT
#include "experiments/timing/flip_statistics.hpp"

#include <cmath>

namespace impetus::inline timing {
namespace {

/// A stamp and the slot that it belongs to, both from the first flip on.
struct SlotStamp {
  double slot{0.0};
  double ms{0.0};
};

double ms_between(const Flip& earlier, const Flip& later) {
  return static_cast<double>(later.flipped_ns - earlier.flipped_ns) / 1e6;
}

std::vector<SlotStamp> slot_stamps(const std::vector<Flip>& flips) {
  std::vector<SlotStamp> stamps;
  std::int64_t slot = 0;
  for (const Flip& flip : flips) {
    slot += stamps.empty() ? 0 : 1 + flip.missed_slots;
    stamps.push_back({static_cast<double>(slot), ms_between(flips.front(), flip)});
  }
  return stamps;
}

/// Least squares, about the means so that long runs lose no digits.
void fit_line(const std::vector<SlotStamp>& stamps, FlipStatistics& into) {
  const auto count = static_cast<double>(stamps.size());
  SlotStamp mean;
  for (const SlotStamp& stamp : stamps) {
    mean.slot += stamp.slot / count;
    mean.ms += stamp.ms / count;
  }
  double slots_squared = 0.0;
  double product = 0.0;
  for (const SlotStamp& stamp : stamps) {
    slots_squared += (stamp.slot - mean.slot) * (stamp.slot - mean.slot);
    product += (stamp.slot - mean.slot) * (stamp.ms - mean.ms);
  }
  into.period_ms = product / slots_squared;
  double squares = 0.0;
  for (const SlotStamp& stamp : stamps) {
    const double off_ms = stamp.ms - mean.ms - into.period_ms * (stamp.slot - mean.slot);
    squares += off_ms * off_ms;
  }
  into.spread_ms = std::sqrt(squares / (count - 2.0));  // two parameters were fitted
  into.period_error_ms = into.spread_ms / std::sqrt(slots_squared);
}

}  // namespace

std::vector<double> intervals_ms(const std::vector<Flip>& flips) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < flips.size(); ++i) {
    intervals.push_back(ms_between(flips[i - 1], flips[i]));
  }
  return intervals;
}

FlipStatistics flip_statistics(const std::vector<Flip>& flips, double nominal_hz) {
  constexpr std::size_t kFewestForALine = 3;
  FlipStatistics result;
  result.flips = static_cast<std::int64_t>(flips.size());
  result.interval_ms = distribution_of(intervals_ms(flips));
  for (const Flip& flip : flips) {
    result.late += flip.late() ? 1 : 0;
    result.missed_slots += flip.missed_slots;
  }
  if (flips.size() >= kFewestForALine) {
    fit_line(slot_stamps(flips), result);
    result.drift_ppm = 1e6 * (result.period_ms * nominal_hz / 1e3 - 1.0);
  }
  return result;
}

}  // namespace impetus::inline timing
