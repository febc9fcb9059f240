// SPDX-License-Identifier: MIT
#include "tests/experiments/crash.hpp"

namespace impetus::crash_test {

TEST(Crash, EightKillsLoseNoAcknowledgedTrialAndEverySessionIsCompleted) {
  const CrashSummary summary = kill_and_resume(8, 20021);
  EXPECT_GE(summary.in_mid_session, 4);  // Of moments drawn uniformly, most fall among the trials.
}

}  // namespace impetus::crash_test
