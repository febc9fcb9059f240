// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace impetus::inline timing {
namespace {

double nearest_rank(const std::vector<double>& sorted, double share) {
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

double sample_sd(const std::vector<double>& values, double mean) {
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  const auto count = static_cast<double>(values.size());
  return count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
}

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

template <typename Event>
std::vector<Event> those_of(const std::vector<Event>& events, InputDevice device,
                            InputRoute route) {
  std::vector<Event> own;
  std::copy_if(events.begin(), events.end(), std::back_inserter(own),
               [&](const Event& event) { return event.device == device && event.route == route; });
  return own;
}

}  // namespace

Distribution distribution_of(std::vector<double> values) {
  if (values.empty()) {
    return {};
  }
  std::sort(values.begin(), values.end());
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return {static_cast<std::int64_t>(values.size()),
          mean,
          sample_sd(values, mean),
          nearest_rank(values, 0.50),
          nearest_rank(values, 0.95),
          nearest_rank(values, 0.99),
          values.back()};
}

double share_above(const std::vector<double>& values, double limit) {
  if (values.empty()) {
    return 0.0;
  }
  const auto above =
      std::count_if(values.begin(), values.end(), [limit](double value) { return value > limit; });
  return static_cast<double>(above) / static_cast<double>(values.size());
}

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

ContentCheck check_content(const std::vector<PatchSighting>& frames) {
  ContentCheck check;
  std::int64_t in_a_row = 0;
  for (const PatchSighting& frame : frames) {
    const bool wrong = frame.seen && *frame.seen != frame.planned;
    check.unreadable += frame.seen ? 0 : 1;
    check.wrong += wrong ? 1 : 0;
    if (wrong && check.first_wrong < 0) {
      check.first_wrong = check.frames;
    }
    in_a_row = wrong ? in_a_row + 1 : 0;
    check.longest_wrong = std::max(check.longest_wrong, in_a_row);
    ++check.frames;
  }
  return check;
}

InputDelay input_delay(const InputTrace& trace, InputDevice device, InputRoute route) {
  const std::vector<SentInput> sent = those_of(trace.sent, device, route);
  const std::vector<ArrivedInput> arrived = those_of(trace.arrived, device, route);
  InputDelay delay{device, route, static_cast<std::int64_t>(sent.size()), 0, {}, 0.0};
  std::int64_t within = 0;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const std::int64_t before_ns =
        i + 1 < sent.size() ? sent[i + 1].sent_ns : std::numeric_limits<std::int64_t>::max();
    const auto found = std::find_if(arrived.begin(), arrived.end(), [&](const ArrivedInput& event) {
      return event.arrived_ns >= sent[i].sent_ns;
    });
    if (found == arrived.end() || found->arrived_ns >= before_ns) {
      ++delay.lost;
      continue;
    }
    const std::int64_t took_ns = found->arrived_ns - sent[i].sent_ns;
    delay.delays_ms.push_back(static_cast<double>(took_ns) / 1e6);
    within += took_ns <= found->uncertainty_ns ? 1 : 0;
  }
  if (!delay.delays_ms.empty()) {
    delay.within_uncertainty_share =
        static_cast<double>(within) / static_cast<double>(delay.delays_ms.size());
  }
  return delay;
}

}  // namespace impetus::inline timing
