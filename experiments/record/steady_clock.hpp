// The machine's monotonic clock: a change of date never moves it.
// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

#include "experiments/record/ports.hpp"

namespace impetus::inline record {

/// CLOCK_MONOTONIC in nanoseconds.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override {
    std::timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }
};

}  // namespace impetus::inline record
