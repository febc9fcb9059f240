// SPDX-License-Identifier: MIT
#include "experiments/run/deadline_work.hpp"

#include <gtest/gtest.h>

#include "tests/engine/builders.hpp"

namespace impetus::deadline_work_test {

/// Goes on by the same time at every look.
class TickingClock final : public Clock {
 public:
  explicit TickingClock(std::int64_t tick_ns) : tick_ns_(tick_ns) {}
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_ += tick_ns_; }

 private:
  std::int64_t tick_ns_;
  mutable std::int64_t now_ns_{0};
};

TEST(DeadlineWork, GrantsWhatIsAskedBeforeTheDeadline) {
  const TickingClock clock(1);
  DeadlineWork meter(clock, 1'000'000);
  meter.start_step();
  for (std::int64_t total = 100; total <= 10'000; total += 100) {
    EXPECT_EQ(meter.request(total, 0), total);
  }
}

TEST(DeadlineWork, OnceRefusedTheAnswerNeverRises) {
  const TickingClock clock(10);
  DeadlineWork meter(clock,
                     30);  // from 10 on: the looks at 20 and 30 are before it, that at 40 is not
  meter.start_step();
  EXPECT_EQ(meter.request(1'000, 0), 1'000);
  EXPECT_EQ(meter.request(2'000, 0), 2'000);
  // The third look is too late; what the slice before had left over is lost with it.
  for (std::int64_t total : {3'000, 2'001, 100'000, 10}) {
    EXPECT_EQ(meter.request(total, 0), 2'000) << total;
  }
}

TEST(DeadlineWork, ARequestAfterTheDeadlineIsRefused) {
  const TickingClock clock(10);
  DeadlineWork meter(clock, 5);
  meter.start_step();
  EXPECT_EQ(meter.request(1, 0), 0);
}

TEST(DeadlineWork, NothingIsGrantedBeforeTheFirstStep) {
  const TickingClock clock(10);
  DeadlineWork meter(clock, 1'000'000'000);
  EXPECT_EQ(meter.request(1, 0), 0);
}

TEST(DeadlineWork, TheNextStepHasItsOwnTime) {
  const TickingClock clock(10);
  DeadlineWork meter(clock, 15);
  for (int step = 0; step < 3; ++step) {
    meter.start_step();
    EXPECT_EQ(meter.request(500, 0), 500);
    EXPECT_EQ(meter.request(50'000, 0), 500);
  }
}

TEST(DeadlineWork, WhatIsReservedMustStillFitBeforeTheDeadline) {
  // Started at 10, looked at 20: 990 ns are left, for fewer than 142 units of 7 ns.
  for (const std::int64_t reserved : {141, 142}) {
    const TickingClock clock(10);
    DeadlineWork meter(clock, 1'000);
    meter.start_step();
    EXPECT_EQ(meter.request(1 + reserved, reserved), reserved == 141 ? 142 : 0);
  }
}

TEST(DeadlineWork, AStepThatProvedSlowReservesMoreTime) {
  // Between the looks at 400,000 and 600,000, 2,000 units took 100 ns each, not 40: the 15,000 ns
  // that are left are enough for fewer than 858 of 17.5 ns.
  for (const std::int64_t reserved : {857, 858}) {
    const TickingClock clock(200'000);
    DeadlineWork meter(clock, 415'000);
    meter.start_step();
    ASSERT_EQ(meter.request(100, 0), 100);
    EXPECT_EQ(meter.request(2'100 + reserved, reserved), reserved == 857 ? 2'957 : 100);
    EXPECT_EQ(meter.request(3'300, 0), reserved == 857 ? 2'957 : 100) << "past the deadline";
  }
}

TEST(DeadlineWork, TooFewUnitsDoNotTellHowSlowAStepIs) {
  // 50 ns a unit both times, and 80,000 ns left for 10,000 units: enough for 7 ns each alone.
  constexpr std::int64_t kReserved = 10'000;
  for (const std::int64_t done : {8, 1'000}) {
    const TickingClock clock(50 * done);
    DeadlineWork meter(clock, 80'000 + 2 * 50 * done);
    meter.start_step();
    ASSERT_EQ(meter.request(100, 0), 100);
    EXPECT_EQ(meter.request(100 + done + kReserved, kReserved), done == 8 ? 10'108 : 100);
  }
}

TEST(DeadlineWork, TheClockIsLookedAtOftenOnlyWhereTimeIsShort) {
  constexpr std::int64_t kTick_ns = 100;
  const auto looks_in = [](std::int64_t ns_per_step) {
    const TickingClock clock(kTick_ns);
    DeadlineWork meter(clock, ns_per_step);
    meter.start_step();
    for (std::int64_t total = 0; total <= 10'240; total += 8) {
      EXPECT_EQ(meter.request(total, 0), total);
    }
    return clock.now_ns() / kTick_ns - 2;  // without that of the start and the one just now
  };
  constexpr std::int64_t kFewest = 20;  // one every 512 units, the next after 8 more
  EXPECT_EQ(looks_in(1'000'000'000), kFewest);
  EXPECT_GT(looks_in(14'000), 2 * kFewest) << "2,000 units would fit at first, then fewer";
}

TEST(DeadlineWork, AStepUnderItReplaysWithTheTotalItGranted) {
  constexpr int kSteps = 240;
  constexpr int kDepth = 4;
  World timed = enclosed_l_blocks(27, kDepth);
  World again = timed;
  const TickingClock clock(1'000);
  int short_of_work = 0;
  for (int step = 0; step < kSteps; ++step) {
    // From no time at all to plenty, so that every kind of cut occurs.
    DeadlineWork meter(clock, 1'000 * (step % 40));
    meter.start_step();
    const StepReport report = timed.step(step_of(kStep_s), meter);
    FixedWork recorded(report.work_granted);
    const StepReport replayed = again.step(step_of(kStep_s), recorded);
    ASSERT_EQ(replayed.state.hash, report.state.hash) << "step " << step;
    ASSERT_EQ(replayed.work_granted, report.work_granted) << "step " << step;
    ASSERT_EQ(replayed.work_spent, report.work_spent) << "step " << step;
    for (const CollisionReport& collision : report.collisions) {
      short_of_work += collision.stop == StopReason::kBudgetSpent ? 1 : 0;
    }
  }
  EXPECT_GT(short_of_work, 0) << "the deadline cut nothing";
}

}  // namespace impetus::deadline_work_test
