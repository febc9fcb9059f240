// All that a timing report tells, measured values and raw ones, as plain data; and what raw values
// say.
//
// The stamps of flips on an absolute grid: how even, how late, how fast the refresh runs.
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
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/frame_grid.hpp"
#include "experiments/record/sent_input.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline timing {

/// What a list of measured values looks like: its middle, its tail, its spread.
/// In the unit of the values; all zero without any.
struct Distribution {
  std::int64_t count{0};
  double mean{0.0};
  double sd{0.0};  ///< of the sample; 0 with fewer than two values
  double median{0.0};
  double p95{0.0};
  double p99{0.0};
  double largest{0.0};
};

/// Percentiles by nearest rank: the least value that so large a share does not exceed.
Distribution distribution_of(std::vector<double> values);

/// The share of the values that are above the limit; 0 without values.
double share_above(const std::vector<double>& values, double limit);

/// What one run of flips says.
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

/// What one frame's patch was to show, and what the window system held after its flip.
struct PatchSighting {
  std::int64_t planned{0};
  std::optional<std::int64_t> seen{};  ///< none: it was no code, or could not be read
};

/// Whether every frame that was shown was the planned one, by its code.
struct ContentCheck {
  std::int64_t frames{0};
  std::int64_t wrong{0};          ///< that showed another code than planned
  std::int64_t unreadable{0};     ///< of which nothing is known
  std::int64_t first_wrong{-1};   ///< number of the first wrong frame; −1: none
  std::int64_t longest_wrong{0};  ///< most wrong frames in a row
  [[nodiscard]] bool all_as_planned() const { return frames > 0 && wrong + unreadable == 0; }
};

/// The frames in the order they were shown.
ContentCheck check_content(const std::vector<PatchSighting>& frames);

/// How long input that was sent took to arrive.
struct InputDelay {
  InputDevice device{InputDevice::kKey};
  InputRoute route{InputRoute::kQueue};
  std::int64_t sent{0};
  std::int64_t lost{0};           ///< that had not arrived when the next was sent
  std::vector<double> delays_ms;  ///< of those that arrived: from sending to the session's stamp
  /// Of those, the share that was sent within the uncertainty that a session states beside its
  /// stamp.
  double within_uncertainty_share{0.0};

  [[nodiscard]] Distribution delay_ms() const { return distribution_of(delays_ms); }
};

/// What was sent arrives before the next of its device and route is sent, or is lost. Arrivals that
/// nothing was sent for are somebody's own and do not count.
InputDelay input_delay(const InputTrace& trace, InputDevice device, InputRoute route);

/// One run of flips on an absolute grid.
struct FlipSeries {
  int bodies{0};  ///< simulated and drawn; 0: a blank picture
  FlipStatistics statistics;
  std::vector<double> intervals_ms;        ///< raw, one fewer than flips
  std::vector<std::int64_t> missed_slots;  ///< raw, one per flip
};

/// From the gaze sample that decided a step to the flip that first showed the step.
struct GazeRun {
  std::string source;
  std::vector<double> latencies_ms;  ///< raw, one per step that was shown and knew the gaze
  double lost_share{0.0};            ///< of the run, time without a valid sample
  std::string clock{};  ///< how an eye tracker's stands to this machine's; "": the same
  std::vector<double> intervals_ms;  ///< raw, between samples as they are stamped
};

/// Events marked for another recorder, during the run with gaze.
struct MarkerRun {
  std::string address;  ///< "": nobody was told
  std::int64_t lost{0};
  std::vector<double> delays_ms;  ///< raw: from the flip to when the system had taken the marker
};

/// Sounds that were asked for after flips, half of them for a tenth of a second later, half at
/// once.
struct SoundRun {
  std::string device;  ///< "": none was asked for
  std::int64_t lost{0};
  /// Raw: from the instant asked for to the onset's leaving the device's buffer.
  std::vector<double> off_ms{};
  std::vector<double> at_once_ms{};  ///< raw: from the flip to the same
};

/// A run of frames with a coded patch, and what was read back of them.
struct ContentRun {
  std::string corner;
  bool readable{false};  ///< false: the window system cannot be asked for what it shows
  ContentCheck check;
};

/// What was measured on, and for how long.
struct TimingFacts {
  std::string build;
  std::string machine;
  std::string started_utc;
  std::string display;     ///< driver, renderer, size, refresh, what a stamp is anchored to
  std::string compositor;  ///< "none", "running" or "not known"
  int width_px{0};
  int height_px{0};
  double nominal_hz{0.0};
  double seconds{0.0};  ///< that each part took
};

/// The whole report.
struct TimingReport {
  TimingFacts facts;
  SyncTest sync;
  std::vector<FlipSeries> runs;  ///< the first is of a blank picture
  std::vector<InputDelay> inputs;
  GazeRun gaze;
  MarkerRun markers;
  SoundRun sounds{};
  ContentRun content;
};

inline constexpr double kPromptGaze_ms = 40.0;  ///< shares of the gaze's latencies are told above
inline constexpr double kLateGaze_ms = 80.0;    ///< this one and this one

}  // namespace impetus::inline timing
