// Staircases: their rule step by step, and where they settle.
// SPDX-License-Identifier: MIT
#include "experiments/design/staircase.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/numerics/random_stream.hpp"

namespace impetus::staircase_test {

/// The levels shown for these answers, '1' a positive one.
std::string levels_for(StaircaseTrack track, const std::string& answers) {
  std::string levels;
  for (const char answer : answers) {
    levels += std::to_string(track.level()) + " ";
    track.answer(answer == '1');
  }
  return levels + std::to_string(track.level());
}

TEST(Staircase, TwoPositivesInARowMakeItHarderAndOneNegativeEasier) {
  const StaircaseTrack track({1, 2, {1}, {}}, 10, 5);
  EXPECT_EQ(levels_for(track, "11110101"), "5 5 4 4 3 4 4 5 5");
}

TEST(Staircase, NegativesInARowAreCountedToo) {
  const StaircaseTrack track({2, 1, {1}, {}}, 10, 5);
  EXPECT_EQ(levels_for(track, "100010"), "5 4 4 5 5 4 4");
}

TEST(Staircase, TheNextStepIsUsedFromEachReversalOnAndTheLastForEver) {
  const StaircaseTrack track({1, 1, {4, 2, 1}, {}}, 100, 50);
  // Down 4, down 4, up 2 (reversal), down 1 (reversal), up 1, down 1.
  EXPECT_EQ(levels_for(track, "110101"), "50 46 42 44 43 44 43");
}

TEST(Staircase, StaysAtEitherEndOfTheLevels) {
  const StaircaseTrack track({1, 1, {3}, {}}, 5, 1);
  EXPECT_EQ(levels_for(track, "110000"), "1 0 0 3 4 4 4");
}

TEST(Staircase, TellsWhatItKnows) {
  StaircaseTrack track({1, 2, {2, 1}, {}}, 10, 5);
  for (const bool positive : {true, true, false, true}) {
    track.answer(positive);
  }
  const std::vector<FactorLevel> expected{{"reversals", 1.0},
                                          {"step", 1.0},
                                          {"positives_in_a_row", 1.0},
                                          {"negatives_in_a_row", 0.0},
                                          {"direction", std::string("easier")}};
  EXPECT_EQ(track.state(), expected);
}

// ---------------------------------------------------------------- where it settles

// One up, n down: pⁿ = ½ (Levitt 1971).
TEST(Staircase, SettlesWhereAStepUpIsAsLikelyAsAStepDown) {
  for (std::int64_t down = 1; down <= 6; ++down) {
    EXPECT_NEAR(settling_share({1, down, {1}, {}}), std::pow(0.5, 1.0 / static_cast<double>(down)),
                1e-12);
    EXPECT_NEAR(settling_share({down, 1, {1}, {}}),
                1.0 - std::pow(0.5, 1.0 / static_cast<double>(down)), 1e-12);
  }
  EXPECT_NEAR(settling_share({2, 2, {1}, {}}), 0.5, 1e-12);
}

/// The share of positive answers of a simulated participant, after the way from the start.
double simulated_share(std::int64_t down) {
  constexpr std::size_t kLevels = 2001;
  constexpr int kWay = 20'000;
  constexpr int kTrials = 400'000;
  StaircaseTrack track({1, down, {1}, {}}, kLevels, kLevels - 1);
  RandomStream random(21, "staircase " + std::to_string(down));
  int positives = 0;
  for (int trial = 0; trial < kWay + kTrials; ++trial) {
    // Small steps: from one level to the next the chance grows by 0.0025 at most.
    const double x = (static_cast<double>(track.level()) - 1000.0) / 100.0;
    const bool positive = random.uniform() < 1.0 / (1.0 + std::exp(-x));
    positives += trial >= kWay && positive ? 1 : 0;
    track.answer(positive);
  }
  return static_cast<double>(positives) / kTrials;
}

// The known answers. The tolerance is that of the method: 1/100 of trial proportions.
TEST(Staircase, OneUpTwoDownConvergesAt7071) { EXPECT_NEAR(simulated_share(2), 0.7071, 0.01); }
TEST(Staircase, OneUpThreeDownConvergesAt7937) { EXPECT_NEAR(simulated_share(3), 0.7937, 0.01); }
TEST(Staircase, OneUpFourDownConvergesAt8409) { EXPECT_NEAR(simulated_share(4), 0.8409, 0.01); }

}  // namespace impetus::staircase_test
