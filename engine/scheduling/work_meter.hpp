// How much work a step may do, counted in node-pair tests.
//
// The engine reads no clock. A meter grants work when asked; the total that it granted, logged,
// is all that a replay needs, because the order of work is deterministic.
// (Dingliana 2002, sec. 3.3.1; eq. 3.9 as a count)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace impetus {

class WorkMeter {
 public:
  virtual ~WorkMeter() = default;

  /// Asks that the step's work may rise to `total_tests` in all; returns the total granted so far.
  /// The work may be done only if the answer is at least `total_tests`. Once a request is refused
  /// the answer never rises again within the step: that makes the total sufficient for a replay.
  virtual std::int64_t request(std::int64_t total_tests) = 0;
};

/// Grants up to a fixed number of tests in each step. Also replays a recording: the total granted
/// then, granted now.
class FixedWork final : public WorkMeter {
 public:
  explicit FixedWork(std::int64_t tests_per_step) : tests_per_step_(tests_per_step) {}

  std::int64_t request(std::int64_t total_tests) override {
    return std::min(total_tests, tests_per_step_);
  }

 private:
  std::int64_t tests_per_step_;
};

inline constexpr std::int64_t kUnlimitedTests = INT64_MAX;

}  // namespace impetus
