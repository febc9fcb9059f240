// A budget in milliseconds: work is granted while the clock is before the step's deadline.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/scheduling/work_meter.hpp"
#include "experiments/session/ports.hpp"

namespace impetus {

class DeadlineWork final : public WorkMeter {
 public:
  DeadlineWork(const Clock& clock, std::int64_t ns_per_step)
      : clock_(&clock), ns_per_step_(ns_per_step) {}
  void start_step() {
    deadline_ns_ = clock_->now_ns() + ns_per_step_;
    granted_ = 0;
    refused_ = false;
  }
  std::int64_t request(std::int64_t total_tests) override {
    refused_ = refused_ || clock_->now_ns() >= deadline_ns_;
    if (!refused_) {
      granted_ = total_tests;
    }
    return granted_;
  }

 private:
  const Clock* clock_;
  std::int64_t ns_per_step_;
  std::int64_t deadline_ns_{0};
  std::int64_t granted_{0};
  bool refused_{false};
};

}  // namespace impetus
