// Michotte's plane: the launching study, run whole by its simulated participants. Direct launching
// stands out; the impression is gone once the second ball moves late, and weaker from afar.
// SPDX-License-Identifier: MIT
#include <string>

#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::launching_observer_test {

double mean_rating(const TemporaryFolder& folder, int delay_ms, int gap_arcmin) {
  return std::stod(value_of(folder / "a.sqlite",
                            "SELECT avg(rating) FROM rated_trial WHERE phase = 'main' AND "
                            "condition ->> 'delay_ms' = " +
                                std::to_string(delay_ms) +
                                " AND condition ->> 'gap_arcmin' = " + std::to_string(gap_arcmin)));
}

TEST(LaunchingStudy, TheImpressionFallsWithDelayAndWithGap) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"run", source_file("protocols/launching.json").string(), "--db",
                           "a.sqlite", "--participants", "8", "--observer",
                           source_file("experiments/observers/launching.json").string()});
  ASSERT_EQ(result.status, 0) << result.errors;
  const double direct = mean_rating(folder, 0, 0);
  EXPECT_GT(direct, 5.3);
  EXPECT_NEAR(mean_rating(folder, 50, 0), direct, 0.9);
  EXPECT_LT(mean_rating(folder, 150, 0), direct - 2.0);
  EXPECT_LT(mean_rating(folder, 300, 0), direct - 2.5);
  EXPECT_LT(mean_rating(folder, 0, 60), direct - 0.5);
  EXPECT_LT(mean_rating(folder, 0, 120), direct - 1.8);
  EXPECT_NEAR(mean_rating(folder, 300, 120), mean_rating(folder, 300, 0), 1.0);
}

}  // namespace impetus::launching_observer_test
