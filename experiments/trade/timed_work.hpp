// How long a piece of work takes, by a clock that is much coarser than it.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "experiments/record/ports.hpp"

namespace impetus::inline trade {

/// Microseconds that `work` takes when it has just been done: the median of three batches, each as
/// often as fits into 20 µs, at most 64 times: enough for a clock that itself takes .3 µs.
template <typename Work>
double timed_us(const Clock& clock, const Work& work) {
  constexpr std::int64_t kBatch_ns = 20'000;
  constexpr std::int64_t kMostTimes = 64;
  const auto batch_us = [&](std::int64_t times) {
    const std::int64_t start_ns = clock.now_ns();
    for (std::int64_t i = 0; i < times; ++i) {
      work();
    }
    return static_cast<double>(clock.now_ns() - start_ns) / (1e3 * static_cast<double>(times));
  };
  const double first_us = batch_us(1);
  const std::int64_t times = std::clamp<std::int64_t>(
      kBatch_ns / std::max<std::int64_t>(1, static_cast<std::int64_t>(1e3 * first_us)), 1,
      kMostTimes);
  std::array<double, 3> found{batch_us(times), batch_us(times), batch_us(times)};
  std::sort(found.begin(), found.end());
  return found[1];
}

}  // namespace impetus::inline trade
