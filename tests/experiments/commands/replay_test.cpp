// Replay of the golden recording: a study file that was made once and must replay for ever.
// SPDX-License-Identifier: MIT
#include <bit>

#include "tests/experiments/golden_study.hpp"

namespace impetus::replay_test {

TEST(GoldenRecording, EveryCellOfTheDesignReplaysBitForBit) {
  Golden golden;
  ASSERT_EQ(golden.attempts.size(), 33U);  // 6 of practice, 27 cells
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_GE(result.steps, 480);
    EXPECT_EQ(words(attempt, result), "");
  }
}

TEST(GoldenRecording, EveryCellOfTheGapStudyReplaysBitForBit) {
  Golden golden("gap");
  ASSERT_EQ(golden.attempts.size(), 33U);
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_EQ(result.steps, 480);
    EXPECT_EQ(words(attempt, result), "");
  }
}

TEST(GoldenRecording, EveryCellOfTheGazeContingentStudyReplaysBitForBit) {
  Golden golden("gaze-contingent");
  ASSERT_EQ(golden.attempts.size(), 12U);  // a round of practice, eight cells
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_EQ(result.steps, 240);
    EXPECT_EQ(words(attempt, result), "");
  }
}

TEST(GoldenRecording, EveryOptionOfTheEngineReplaysBitForBit) {
  Golden golden("every-option");
  ASSERT_EQ(golden.attempts.size(), 36U);  // six kinds of trees, six reductions
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_EQ(result.steps, 60);
    EXPECT_EQ(words(attempt, result), "");
  }
}

/// Imposed spins between limits that were solved before the plan was stored.
TEST(GoldenRecording, EveryCellOfTheResponseStudyReplaysBitForBit) {
  Golden golden("response");
  ASSERT_EQ(golden.attempts.size(), 33U);
  std::int64_t solved = 0;
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_GE(result.steps, 480);
    EXPECT_EQ(words(attempt, result), "");
    solved += attempt.trial.solved.empty() ? 0 : 1;
  }
  EXPECT_EQ(solved, 33);
}

/// Levels that QUEST+ chose trial by trial, with distractors.
TEST(GoldenRecording, EveryTrackOfTheGapThresholdsReplaysBitForBit) {
  Golden golden("gap-thresholds");
  ASSERT_EQ(golden.attempts.size(), 22U);  // 6 of practice, 4 tracks of 4 trials
  for (const StoredAttempt& attempt : golden.attempts) {
    const ReplayResult result = replay(golden.stage(attempt), golden.steps(attempt));
    EXPECT_GE(result.steps, 240);
    EXPECT_EQ(words(attempt, result), "");
  }
  const char* const chosen = "SELECT count(*) FROM trial WHERE adaptive_state IS NOT NULL";
  EXPECT_EQ(golden.study.database().execAndGet(chosen).getInt(), 16);
}

TEST(GoldenRecording, OneBitOfAnInitialVelocityIsCaughtAndNamed) {
  Golden golden;
  const StoredAttempt& attempt = golden.attempts[7];
  StagedScene scene = golden.stage(attempt);
  double& momentum = scene.world.mutable_states()[1].linear_momentum.x();
  momentum = std::bit_cast<double>(std::bit_cast<std::uint64_t>(momentum) ^ 1U);
  const ReplayResult result = replay(std::move(scene), golden.steps(attempt));
  EXPECT_EQ(words(attempt, result), "trial 8, step 0, body right, linear momentum");
}

TEST(GoldenRecording, TheFloorIsWorkedWhateverWasGranted) {
  // Two single spheres need one test, which is the floor: no grant can change the outcome.
  Golden golden;
  std::vector<StepRecord> steps = golden.steps(golden.attempts[0]);
  for (StepRecord& step : steps) {
    step.work_granted = 0;
  }
  EXPECT_FALSE(replay(golden.stage(golden.attempts[0]), steps).divergence);
}

TEST(GoldenRecording, ShowsEveryStateToAWatcher) {
  Golden golden;
  const std::vector<StepRecord> steps = golden.steps(golden.attempts[0]);
  std::vector<std::uint64_t> hashes;
  replay(golden.stage(golden.attempts[0]), steps,
         [&](std::int64_t step, const World& world, const StepReport&) {
           EXPECT_EQ(step, steps[hashes.size()].step);
           hashes.push_back(hash_state(world.states()).hash);
         });
  ASSERT_EQ(hashes.size(), steps.size());
  EXPECT_EQ(hashes.back(), steps.back().state.hash);
}

}  // namespace impetus::replay_test
