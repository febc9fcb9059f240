// How a tracker's clock stands to this machine's.
// SPDX-License-Identifier: MIT
#include "experiments/trackers/clock_offset.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

namespace impetus::clock_offset_test {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kTrue_ns = 4'321'000'000;

TEST(RoundTripOffset, IsOfTheFastestTripAndErrsByHalfOfItAtMost) {
  RoundTripOffset offset;
  offset.add(0, 5 * kMs - kTrue_ns, 20 * kMs);  // the way there is the shorter one
  offset.add(100 * kMs, 101 * kMs - kTrue_ns, 102 * kMs);
  offset.add(200 * kMs, 230 * kMs - kTrue_ns, 240 * kMs);
  EXPECT_EQ(offset.estimate().offset_ns, kTrue_ns);
  EXPECT_EQ(offset.estimate().error_ns, kMs);
}

TEST(RoundTripOffset, IsWithinItsErrorWhateverTheDelays) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::int64_t> delay_ns(10'000, 5 * kMs);
  RoundTripOffset offset;
  std::int64_t now_ns = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t there_ns = now_ns + delay_ns(random);
    const std::int64_t back_ns = there_ns + delay_ns(random);
    offset.add(now_ns, there_ns - kTrue_ns, back_ns);
    // |offset - truth| <= half the round trip
    EXPECT_LE(std::abs(offset.estimate().offset_ns - kTrue_ns), offset.estimate().error_ns)
        << "seed " << seed << ", trip " << i;
    now_ns = back_ns;
  }
}

TEST(RoundTripOffset, FollowsAClockThatDrifts) {
  RoundTripOffset offset;
  // 40 us in a second, for ten minutes; trips of 1 ms.
  for (std::int64_t second = 0; second < 600; ++second) {
    const std::int64_t now_ns = second * 1000 * kMs;
    const std::int64_t drifted_ns = kTrue_ns + second * 40'000;
    offset.add(now_ns, now_ns + kMs / 2 - drifted_ns, now_ns + kMs);
    EXPECT_LE(std::abs(offset.estimate().offset_ns - drifted_ns), kMs / 2);
  }
}

TEST(RoundTripOffset, FollowsAClockThatWasSet) {
  RoundTripOffset offset;
  offset.add(0, 1 - kTrue_ns, 2);
  offset.add(kMs, 2 * kMs, 3 * kMs);
  EXPECT_EQ(offset.estimate().offset_ns, 0);
}

TEST(OneWayOffset, IsOfTheFastestDeliveryAndTellsHowLateOthersAre) {
  OneWayOffset offset;
  for (std::int64_t i = 0; i < 100; ++i) {
    const std::int64_t late_ns = i % 10 == 3 ? 0 : 2 * kMs;
    offset.add(i * 5 * kMs - kTrue_ns, i * 5 * kMs + late_ns);
  }
  EXPECT_EQ(offset.estimate().offset_ns, kTrue_ns);
  EXPECT_EQ(offset.estimate().error_ns, 2 * kMs);
  EXPECT_TRUE(offset.estimate().one_way);
}

TEST(OneWayOffset, FollowsAClockThatDriftsEitherWay) {
  for (const std::int64_t drift_ns : {-40'000, 40'000}) {
    OneWayOffset offset;
    for (std::int64_t second = 0; second < 600; ++second) {
      const std::int64_t now_ns = second * 1000 * kMs;
      const std::int64_t drifted_ns = kTrue_ns + second * drift_ns;
      offset.add(now_ns - drifted_ns, now_ns);
      EXPECT_LE(std::abs(offset.estimate().offset_ns - drifted_ns), kMs / 10);
    }
  }
}

TEST(Nanoseconds, AreOfTimesThatAClockShows) {
  EXPECT_EQ(nanoseconds(1.5), 1'500'000'000);
  EXPECT_FALSE(nanoseconds(1e300));
  EXPECT_FALSE(nanoseconds(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace impetus::clock_offset_test
