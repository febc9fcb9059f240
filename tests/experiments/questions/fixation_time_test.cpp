// The cross before a stimulus: as long as the protocol says, or drawn for each.
// SPDX-License-Identifier: MIT
#include "experiments/questions/fixation_time.hpp"

#include <set>

#include "tests/experiments/asked_study.hpp"

namespace impetus::fixation_time_test {

TEST(FixationTime, IsDrawnInWholeFramesFromTheLeastToTheMost) {
  std::set<std::int64_t> drawn;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    drawn.insert(fixation_frames({100.0, 200.0}, seed, 1, 60.0));
  }
  EXPECT_EQ(drawn, (std::set<std::int64_t>{6, 7, 8, 9, 10, 11, 12}));
}

TEST(FixationTime, FollowsFromSeedAndIntervalAlone) {
  const FixationTime time{500.0, 1500.0};
  EXPECT_EQ(fixation_frames(time, 7, 1, 60.0), fixation_frames(time, 7, 1, 60.0));
  EXPECT_NE(fixation_frames(time, 7, 1, 60.0), fixation_frames(time, 7, 2, 60.0));
  EXPECT_NE(fixation_frames(time, 7, 1, 60.0), fixation_frames(time, 8, 1, 60.0));
  EXPECT_EQ(fixation_frames({500.0, 500.0}, 7, 1, 60.0), 30);
}

TEST(FixationTime, IsShownAndRecordedFrameByFrame) {
  json protocol = asked_protocol({kAskYesNo});
  protocol["timing"]["fixation_ms"] = {100, 500};
  for (const std::uint64_t seed : {1U, 2U}) {
    TestLab lab(60.0, study_of(protocol));
    const AttemptRecord record = answered_trial(lab, trial_with_delay(0, seed), 0);
    const auto crosses = std::count_if(
        record.frames.begin(), record.frames.end(),
        [](const FrameRecord& frame) { return frame.phase == FramePhase::kFixation; });
    EXPECT_EQ(crosses, fixation_frames({100.0, 500.0}, seed, 1, 60.0));
  }
}

TEST(FixationTime, EveryRefusalNamesThePlace) {
  json protocol = asked_protocol({kAskYesNo});
  const auto refused = [&](const json& time) {
    protocol["timing"]["fixation_ms"] = time;
    return asked_refusal(protocol);
  };
  EXPECT_EQ(refused({1500, 500}),
            "asked.json:/timing/fixation_ms: expected the least before the most, got [1500,500]");
  EXPECT_EQ(refused({500, 1000, 1500}),
            "asked.json:/timing/fixation_ms: expected a number or a list of 2 values ≥ 0 and ≤ "
            "60000, got [500,1000,1500]");
  EXPECT_EQ(refused({500, -1}),
            "asked.json:/timing/fixation_ms/1: expected a number ≥ 0 and ≤ 60000, got -1");
}

}  // namespace impetus::fixation_time_test
