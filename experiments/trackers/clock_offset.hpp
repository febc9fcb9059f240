// How a tracker's clock, in seconds, stands to this machine's, estimated from messages.
//
//   round trip   sent |----- remote_s -----| received    offset = middle - remote_s, to half the
//   trip one way               remote_s ------> | arrived     offset = the least (arrived -
//   remote_s)
//
// What was estimated before is worth less with every second: two clocks drift apart by up to
// kDrift. A new estimate is taken when it is better than the aged one, or contradicts it: then the
// tracker's clock was set. (Mills 1992, RFC 1305, sec. 3.4: least delay, and dispersion with age)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace impetus::inline trackers {

/// Seconds by which the clocks of two computers drift apart in a second, at worst.
inline constexpr double kDrift = 50e-6;

/// What is known of a tracker's clock.
struct ClockEstimate {
  std::int64_t offset_ns{0};  ///< this machine's time minus the tracker's
  std::int64_t error_ns{
      0};               ///< at most; one way: what 95 % of deliveries take longer than the best
  bool one_way{false};  ///< then the delay of the fastest delivery itself is not known
};

/// Nanoseconds of a tracker's seconds; none: no time that a clock shows.
std::optional<std::int64_t> nanoseconds(double remote_s);

/// Of a tracker that says its time when it is asked.
class RoundTripOffset {
 public:
  /// Times of this machine: when it asked, and when the answer was there.
  void add(std::int64_t sent_ns, std::int64_t remote_ns, std::int64_t received_ns);

  [[nodiscard]] bool is_known() const { return known_; }
  [[nodiscard]] ClockEstimate estimate() const { return estimate_; }

 private:
  ClockEstimate estimate_;
  std::int64_t estimated_ns_{0};
  bool known_{false};
};

/// Of a tracker that only sends.
class OneWayOffset {
 public:
  void add(std::int64_t remote_ns, std::int64_t arrived_ns);

  [[nodiscard]] bool is_known() const { return !recent_ns_.empty(); }
  [[nodiscard]] ClockEstimate estimate() const;

 private:
  std::int64_t offset_ns_{0};
  std::int64_t estimated_ns_{0};
  std::vector<std::int64_t> recent_ns_;  ///< arrived − remote, a ring
  std::size_t next_{0};
};

}  // namespace impetus::inline trackers
