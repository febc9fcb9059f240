// A budget that counts from where a step's floor ends, so that it means as much in a step of many
// collisions as in one of few.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/scheduling/work_costs.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline trade {

/// Grants the floor and so many units more.
class WorkBeyondFloor final : public WorkMeter {
 public:
  explicit WorkBeyondFloor(std::int64_t units_per_step) : units_(units_per_step) {}

  /// To be called before each step.
  void start_step() { most_ = -1; }

  /// The first request of refinement is its floor; other phases get what they ask for.
  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t /*reserved*/) override {
    if (phase != WorkPhase::kRefinement) {
      return kUnlimitedTests;
    }
    if (most_ < 0) {
      most_ = units_ < kUnlimitedTests - total ? total + units_ : kUnlimitedTests;
    }
    return std::min(total, most_);
  }

 private:
  std::int64_t units_;
  std::int64_t most_{-1};
};

/// Tests alone, as `costs` count them: what follows them depends on where refinement stands, not on
/// the order in which it got there.
inline WorkCosts costs_of_tests(const WorkCosts& costs) {
  return {costs.sphere_test, costs.volume_test, 0, 0, 0};
}

}  // namespace impetus::inline trade
