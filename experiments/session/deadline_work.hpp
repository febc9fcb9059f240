// A budget in time: work is granted in slices while the clock is before the step's deadline.
//
//   |slice|slice|slice|slice|slice          the clock is read once before each slice
//   start                  deadline|refused for the rest of the step
//
// The clock decides only how much is granted. That total, logged, replays the step with FixedWork.
// (Dingliana 2002, sec. 3.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/scheduling/work_meter.hpp"
#include "experiments/session/ports.hpp"

namespace impetus {

class DeadlineWork final : public WorkMeter {
 public:
  /// `clock` must outlive it. Grants nothing before the first start_step().
  DeadlineWork(const Clock& clock, std::int64_t ns_per_step)
      : clock_(&clock), ns_per_step_(ns_per_step) {}

  /// Starts the next step's time; call it just before World::step().
  void start_step();

  std::int64_t request(std::int64_t total_tests) override;

 private:
  const Clock* clock_;
  std::int64_t ns_per_step_;
  std::int64_t deadline_ns_{0};
  std::int64_t granted_{0};
  std::int64_t slice_end_{0};  ///< granted without another look at the clock
  bool refused_{true};
};

}  // namespace impetus
