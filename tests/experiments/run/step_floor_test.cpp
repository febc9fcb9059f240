// What a scene's steps take of which nothing is granted.
// SPDX-License-Identifier: MIT
#include "experiments/run/step_floor.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/test_scenes.hpp"

namespace impetus::step_floor_test {

/// A clock of which every look takes a microsecond, but for a few, as where the program is
/// interrupted.
class InterruptedClock final : public WorkClock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override {
    ++looks_;
    now_ns_ += looks_ == 8 || looks_ == 300 ? 5'000'000 : 1'000;
    return now_ns_;
  }

 private:
  mutable std::int64_t looks_{0};
  mutable std::int64_t now_ns_{0};
};

/// A clock of which looks take a microsecond in the first 300 steps, two in the next and then
/// three.
class SlowerEachTime final : public WorkClock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override {
    constexpr std::int64_t kLooksOfARun = 600;
    now_ns_ += 1'000 * (1 + looks_ / kLooksOfARun);
    ++looks_;
    return now_ns_;
  }

 private:
  mutable std::int64_t looks_{0};
  mutable std::int64_t now_ns_{0};
};

TEST(StepFloor, IsTheLongestStepAndNoInterruption) {
  EXPECT_DOUBLE_EQ(floor_ms(built(free_scene()), InterruptedClock()), 1e-3);
}

TEST(StepFloor, IsNotTheLuckiestOfThreeTries) {
  EXPECT_DOUBLE_EQ(floor_ms(built(free_scene()), SlowerEachTime()), 2e-3);
}

}  // namespace impetus::step_floor_test
