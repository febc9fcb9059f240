// What the stamps of flips on an absolute grid say: how even, how late, how fast the refresh runs.
//
//   stamp   |           .  ' /        slope       the true period: drift against the nominal one
//           |      . ' /              distances   from the line: spread, which drift is no part of
//           | . '/                    gaps        of two slots: a late frame, whatever the spread
//           +---------------- slot
//
// Drift is not jitter: a display of 59.94 Hz that is called 60 would otherwise seem to spread more
// the longer one looks.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/record/frame_grid.hpp"
#include "experiments/timing/distribution.hpp"

namespace impetus::inline timing {

struct FlipStatistics {
  std::int64_t flips{0};
  std::int64_t late{0};          ///< that came a slot or more too late
  std::int64_t missed_slots{0};  ///< that went by without their frame
  Distribution interval_ms;      ///< between flips that followed each other
  double period_ms{0.0};         ///< slope of the stamps over their slots (least squares)
  double period_error_ms{0.0};   ///< its standard error
  double drift_ppm{0.0};         ///< of the period, against the nominal one; > 0: longer
  double spread_ms{0.0};         ///< standard deviation of the stamps about the line

  [[nodiscard]] double late_share() const {
    return flips > 0 ? static_cast<double>(late) / static_cast<double>(flips) : 0.0;
  }
  /// Refreshes per second, and half of its 95 % confidence interval (normal; for hundreds of
  /// flips).
  [[nodiscard]] double refresh_hz() const { return period_ms > 0.0 ? 1e3 / period_ms : 0.0; }
  [[nodiscard]] double refresh_interval_hz() const {
    return period_ms > 0.0 ? 1.96 * period_error_ms * refresh_hz() / period_ms : 0.0;
  }
};

/// Milliseconds between flips that followed each other, one fewer than there are flips.
std::vector<double> intervals_ms(const std::vector<Flip>& flips);

/// Of the flips of one run on one grid, in order. Slope, drift and spread are 0 with fewer than
/// three. Precondition: nominal_hz > 0.
FlipStatistics flip_statistics(const std::vector<Flip>& flips, double nominal_hz);

}  // namespace impetus::inline timing
