// The thread's own CPU time: shared machines stall a thread for milliseconds, and this does not
// count them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "experiments/record/ports.hpp"

namespace impetus {

/// Nanoseconds of CPU time that this thread has had.
std::int64_t thread_cpu_ns();

/// What one look at the clock costs (nanoseconds, median): subtracted from short measurements.
double clock_cost_ns();

class ThreadCpuClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return thread_cpu_ns(); }
};

/// In the unit of the samples; zeros of no samples.
struct Spread {
  double median{0.0};
  double mean{0.0};
  double p99{0.0};
  double longest{0.0};
};

Spread spread_of(std::vector<double> samples);

}  // namespace impetus
