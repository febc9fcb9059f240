// SPDX-License-Identifier: MIT
#include "experiments/record/frame_grid.hpp"

#include <gtest/gtest.h>

#include "experiments/session/timing_check.hpp"

namespace impetus::frame_grid_test {

constexpr std::int64_t kMs = 1'000'000;

TEST(FrameGrid, DoesNotDriftOverAnHourOfFrames) {
  FrameGrid grid(60.0);
  grid.restart(5 * kMs);
  constexpr std::int64_t kFrames = 60 * 3600;
  for (std::int64_t frame = 1; frame < kFrames; ++frame) {
    grid.flipped(0, grid.next_due_ns());
  }
  EXPECT_EQ(grid.next_due_ns(), 5 * kMs + 3'600'000 * kMs);
}

TEST(FrameGrid, AFlipWithinHalfAPeriodIsNotLate) {
  FrameGrid grid(100.0);
  grid.restart(0);
  const Flip flip = grid.flipped(9 * kMs, 14 * kMs);
  EXPECT_EQ(flip.scheduled_ns, 10 * kMs);
  EXPECT_EQ(flip.lateness_ns(), 4 * kMs);
  EXPECT_FALSE(flip.late());
  EXPECT_EQ(grid.next_due_ns(), 20 * kMs);
}

TEST(FrameGrid, AfterAMissTheGridMovesOnByWholeSlots) {
  FrameGrid grid(100.0);
  grid.restart(0);
  const Flip flip = grid.flipped(9 * kMs, 31 * kMs);
  EXPECT_TRUE(flip.late());
  EXPECT_EQ(flip.missed_slots, 2);
  // The late frame took the slot at 30 ms, so the next is due at 40: back on the absolute grid.
  EXPECT_EQ(grid.next_due_ns(), 40 * kMs);
}

TEST(FrameGrid, AnEarlyFlipStaysInItsSlot) {
  FrameGrid grid(100.0);
  grid.restart(0);
  EXPECT_EQ(grid.flipped(0, 2 * kMs).missed_slots, 0);
  EXPECT_EQ(grid.next_due_ns(), 20 * kMs);
}

std::vector<std::int64_t> flips_every(std::int64_t period_ns, int count, std::int64_t jitter_ns) {
  std::vector<std::int64_t> stamps;
  for (int i = 0; i < count; ++i) {
    stamps.push_back(i * period_ns + (i % 2 == 0 ? jitter_ns : -jitter_ns));
  }
  return stamps;
}

TEST(SyncTest, SteadyFlipsAtTheNominalRatePass) {
  const SyncTest test = judge_flips(flips_every(16'666'667, 120, 50'000), 60.0);
  EXPECT_TRUE(test.passed);
  EXPECT_EQ(test.valid_flips, 119);
  // An odd number of alternating intervals: one of ±100 µs is left over, spread over 119.
  EXPECT_NEAR(test.mean_interval_ns, 16'666'667.0, 100e3 / 119 + 1.0);
}

TEST(SyncTest, FlipsThatDoNotWaitForTheRefreshFail) {
  const SyncTest test = judge_flips(flips_every(300'000, 120, 0), 60.0);
  EXPECT_FALSE(test.passed);
  EXPECT_EQ(test.verdict,
            "flips do not follow the display's refresh: only 0 intervals were within 20 % of "
            "16.67 ms, 50 are needed");
}

TEST(SyncTest, AnotherRateThanNominalFails) {
  EXPECT_FALSE(judge_flips(flips_every(16'950'000, 120, 0), 60.0).passed);  // 1.7 % off
  EXPECT_TRUE(judge_flips(flips_every(16'683'333, 120, 0), 60.0).passed);   // 59.94 Hz
}

TEST(SyncTest, TriesThreeTimesAtMostAndStopsAtAPass) {
  int runs = 0;
  const FlipRun second_is_steady = [&](int count) {
    return flips_every(++runs == 2 ? 16'666'667 : 100'000, count, 0);
  };
  const SyncTest passed = run_sync_test(second_is_steady, 60.0);
  EXPECT_TRUE(passed.passed);
  EXPECT_EQ(passed.tries, 2);

  const SyncTest failed = run_sync_test([](int count) { return flips_every(1, count, 0); }, 60.0);
  EXPECT_FALSE(failed.passed);
  EXPECT_EQ(failed.tries, 3);
}

}  // namespace impetus::frame_grid_test
