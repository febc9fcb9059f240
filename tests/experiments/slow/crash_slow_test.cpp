// SPDX-License-Identifier: MIT
#include "tests/experiments/crash.hpp"

namespace impetus::crash_slow_test {

TEST(CrashSlow, AHundredAndFiftyKillsLoseNoAcknowledgedTrialAndEverySessionIsCompleted) {
  const CrashSummary summary = kill_and_resume(150, std::random_device{}());
  // Kills are drawn by the trials saved: most fall among them.
  EXPECT_GE(summary.in_mid_session, 100);
}

}  // namespace impetus::crash_slow_test
