// SPDX-License-Identifier: MIT
#include "tests/experiments/crash.hpp"

namespace impetus {
namespace {

TEST(CrashSlow, AHundredAndFiftyKillsLoseNoAcknowledgedTrialAndEverySessionIsCompleted) {
  const CrashSummary summary = kill_and_resume(150, std::random_device{}());
  EXPECT_GE(summary.in_mid_session, 45);  // Of moments drawn uniformly, most fall among the trials.
}

}  // namespace
}  // namespace impetus
