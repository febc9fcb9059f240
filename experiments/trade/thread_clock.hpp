// The time that this thread has computed: what else the machine does is not in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

#include "experiments/record/ports.hpp"

namespace impetus::inline trade {

/// CLOCK_THREAD_CPUTIME_ID in nanoseconds. Looking at it takes some tenths of a microsecond.
class ThreadClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override {
    std::timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }
};

}  // namespace impetus::inline trade
