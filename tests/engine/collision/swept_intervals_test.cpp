// Intervals compared by the block against intervals one by one.
// SPDX-License-Identifier: MIT
#include "engine/collision/broad_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/engine/builders.hpp"

namespace impetus::swept_intervals_test {

constexpr std::uint64_t kSeed = 82;

SweptInterval random_interval(RandomStream& random, std::int32_t body) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto any = [&] { return 0.25 * static_cast<double>(random.below(12)); };
  const auto after = [&](double least) {
    return least + 0.25 * static_cast<double>(random.below(5));
  };
  SweptInterval interval{any(), 0.0, {any(), any()}, {}, body, true};
  interval.greatest = after(interval.least);
  interval.across_greatest = {after(interval.across_least[0]), after(interval.across_least[1])};
  if (random.below(10) == 0) {
    interval = {-kInfinity, kInfinity, {-kInfinity, -kInfinity}, {kInfinity, kInfinity},
                body,       true};
  }
  return interval;
}

bool meet(const SweptInterval& x, const SweptInterval& y) {
  return y.least <= x.greatest && y.across_least[0] <= x.across_greatest[0] &&
         x.across_least[0] <= y.across_greatest[0] && y.across_least[1] <= x.across_greatest[1] &&
         x.across_least[1] <= y.across_greatest[1];
}

TEST(SweptIntervals, ABlockMeetsWhatItsIntervalsMeet) {
  RandomStream random(kSeed, "intervals");
  SweptIntervals swept;
  int meetings = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<SweptInterval> sorted;
    for (std::uint64_t count = 1 + random.below(40); count > 0; --count) {
      sorted.push_back(random_interval(random, static_cast<std::int32_t>(count)));
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const auto& x, const auto& y) { return x.least < y.least; });
    swept.clear();
    ASSERT_EQ(swept.add(sorted), 0U);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      ASSERT_FALSE(swept.reaches(i, sorted.size()));
      for (std::size_t first = i + 1; first < sorted.size(); ++first) {
        ASSERT_EQ(swept.reaches(i, first), sorted[first].least <= sorted[i].greatest);
        std::uint32_t expected = 0;
        for (std::size_t j = first; j < std::min(first + kLanes, sorted.size()); ++j) {
          expected |= meet(sorted[i], sorted[j]) ? 1U << (j - first) : 0U;
        }
        meetings += expected != 0 ? 1 : 0;
        for (const LaneWidth width : {LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight}) {
          if (width <= widest_lanes()) {
            ASSERT_EQ(swept.meeting(i, first, width), expected)
                << "seed " << kSeed << ", trial " << trial << ", width " << static_cast<int>(width);
          }
        }
      }
    }
  }
  EXPECT_GT(meetings, 1'000);
}

}  // namespace impetus::swept_intervals_test
