// A budget in time: work is granted in slices while the clock is before the step's deadline.
//
//   |  slice  |  slice  | slice |slice|slice    the clock is read once before each slice, the
//   start                      deadline|refused   shorter the less time is left
//
// What is reserved for the phases that follow detection must still fit before the deadline: a
// request is refused when the time left does not cover it, at kLeastNsPerUnit, and as much more as
// the step's first thousand units took longer than they usually do.
//
// The clock decides only how much is granted. That total, logged, replays the step with FixedWork.
// (Dingliana 2002, sec. 3.3.1; eq. 3.9)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/scheduling/work_meter.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline run {

/// Of what follows detection: 2 to 6 ns as measured, the more the more contacts depend on each
/// other.
inline constexpr double kLeastNsPerUnit = 7.0;

/// Grants work until a step's time is up, by a clock.
class DeadlineWork final : public WorkMeter {
 public:
  /// `clock` must outlive it. Grants nothing before the first start_step().
  DeadlineWork(const Clock& clock, std::int64_t ns_per_step)
      : clock_(&clock), ns_per_step_(ns_per_step) {}

  /// Starts the next step's time; call it just before World::step().
  void start_step();

  std::int64_t request(std::int64_t total, std::int64_t reserved) override;

 private:
  /// Units for which there is time before the deadline, besides those reserved.
  double fitting_units(std::int64_t now_ns, std::int64_t done, std::int64_t reserved);

  const Clock* clock_;
  std::int64_t ns_per_step_;
  std::int64_t deadline_ns_{0};
  std::int64_t granted_{0};
  std::int64_t slice_end_{0};  ///< granted without another look at the clock
  bool refused_{true};

  /// At the first look of the step, after the floor: what was done by then, and when.
  std::int64_t first_done_{-1};
  std::int64_t first_ns_{0};
  double ns_per_unit_{0.0};  ///< of what follows detection; 0 until enough units are done to tell
};

}  // namespace impetus::inline run
