// What a timing report computes, from made-up flips, input and frames whose numbers are known.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "engine/numerics/random_stream.hpp"
#include "experiments/record/photodiode_patch.hpp"
#include "experiments/timing/timing_report.hpp"

namespace impetus::timing_statistics_test {

constexpr double kNominalHz = 60.0;
constexpr double kNominal_ms = 1e3 / kNominalHz;
constexpr double kOfAStamp_ms = 1e-6;  // stamps are whole nanoseconds

/// Flips that come when `flipped_ms` says, each in the slot after the one before.
std::vector<Flip> flips_at(int count, const std::function<double(int)>& flipped_ms) {
  std::vector<Flip> flips;
  for (int i = 0; i < count; ++i) {
    Flip flip;
    flip.flipped_ns = 1'000'000'000'000 + std::llround(1e6 * flipped_ms(i));
    flips.push_back(flip);
  }
  return flips;
}

double jitter_ms(int flip) { return flip % 2 == 0 ? 0.25 : -0.25; }

TEST(Distribution, PercentilesAreByNearestRank) {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) {
    values.push_back(i);
  }
  const Distribution found = distribution_of(values);
  EXPECT_EQ(found.count, 100);
  EXPECT_EQ(found.median, 50.0);
  EXPECT_EQ(found.p95, 95.0);
  EXPECT_EQ(found.p99, 99.0);
  EXPECT_EQ(found.largest, 100.0);
  EXPECT_EQ(found.mean, 50.5);
  // √(n(n + 1) / 12) for the numbers 1 to n
  EXPECT_NEAR(found.sd, std::sqrt(100.0 * 101.0 / 12.0), 1e-12);
}

TEST(Distribution, OneValueIsAllOfThemAndNoneIsZero) {
  EXPECT_EQ(distribution_of({3.0}).p99, 3.0);
  EXPECT_EQ(distribution_of({3.0}).sd, 0.0);
  EXPECT_EQ(distribution_of({}).count, 0);
}

TEST(Distribution, AShareIsOfWhatLiesAboveTheLimitNotOnIt) {
  EXPECT_EQ(share_above({40.0, 40.5, 90.0, 10.0}, 40.0), 0.5);
  EXPECT_EQ(share_above({}, 40.0), 0.0);
}

TEST(FlipStatistics, ASlopeIsDriftAndNoSpread) {
  const double period_ms = 1e3 / 59.94;
  const FlipStatistics found =
      flip_statistics(flips_at(600, [&](int i) { return i * period_ms; }), kNominalHz);
  EXPECT_EQ(found.flips, 600);
  EXPECT_EQ(found.late, 0);
  EXPECT_NEAR(found.refresh_hz(), 59.94, 1e-6);
  EXPECT_NEAR(found.drift_ppm, 1e6 * (60.0 / 59.94 - 1.0), 0.01);  // 0.01 ppm: stamps over 10 s
  EXPECT_LT(found.spread_ms, kOfAStamp_ms);
}

TEST(FlipStatistics, SpreadIsTheSameWithDriftAndWithout) {
  const auto steady = flip_statistics(
      flips_at(600, [](int i) { return i * kNominal_ms + jitter_ms(i); }), kNominalHz);
  const auto drifting = flip_statistics(
      flips_at(600, [](int i) { return i * kNominal_ms * 1.002 + jitter_ms(i); }), kNominalHz);
  // ± .25 about the line; the line itself takes a part of 1e-5 of it.
  EXPECT_NEAR(steady.spread_ms, 0.25 * std::sqrt(600.0 / 598.0), 1e-5);
  EXPECT_NEAR(drifting.spread_ms, steady.spread_ms, 2.0 * kOfAStamp_ms);
  EXPECT_NEAR(drifting.drift_ppm - steady.drift_ppm, 2000.0, 0.01);
  EXPECT_NEAR(steady.interval_ms.largest, kNominal_ms + 0.5, 2.0 * kOfAStamp_ms);
}

TEST(FlipStatistics, LateFramesAreCountedAndDoNotBendTheSlope) {
  // Flip 100 comes two slots late, flip 300 one; all that follow come as much later.
  auto slot_of = [](int i) { return i + (i >= 100 ? 2 : 0) + (i >= 300 ? 1 : 0); };
  std::vector<Flip> flips = flips_at(600, [&](int i) { return slot_of(i) * kNominal_ms; });
  flips[100].missed_slots = 2;
  flips[300].missed_slots = 1;
  const FlipStatistics found = flip_statistics(flips, kNominalHz);
  EXPECT_EQ(found.late, 2);
  EXPECT_EQ(found.missed_slots, 3);
  EXPECT_NEAR(found.late_share(), 2.0 / 600.0, 1e-15);
  EXPECT_NEAR(found.interval_ms.largest, 3.0 * kNominal_ms, 2.0 * kOfAStamp_ms);
  EXPECT_NEAR(found.interval_ms.median, kNominal_ms, 2.0 * kOfAStamp_ms);
  EXPECT_NEAR(found.drift_ppm, 0.0, 0.01);
  EXPECT_LT(found.spread_ms, kOfAStamp_ms);
}

TEST(FlipStatistics, TheIntervalOfTheRateHoldsTheTrueOneNineteenTimesInTwenty) {
  constexpr int kRuns = 400;
  RandomStream draws(20, "flips");
  int held = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto found = flip_statistics(
        flips_at(300, [&](int i) { return i * kNominal_ms + 2.0 * draws.uniform(); }), kNominalHz);
    held += std::abs(found.refresh_hz() - kNominalHz) <= found.refresh_interval_hz() ? 1 : 0;
  }
  // Four standard deviations of a binomial count.
  EXPECT_NEAR(held, 0.95 * kRuns, 4.0 * std::sqrt(kRuns * 0.95 * 0.05));
}

TEST(FlipStatistics, TwoFlipsHaveAnIntervalButNoSlope) {
  const FlipStatistics found =
      flip_statistics(flips_at(2, [](int i) { return i * 20.0; }), kNominalHz);
  EXPECT_EQ(found.interval_ms.count, 1);
  EXPECT_EQ(found.drift_ppm, 0.0);
  EXPECT_EQ(found.refresh_hz(), 0.0);
  EXPECT_EQ(flip_statistics({}, kNominalHz).flips, 0);
}

// ---------------------------------------------------------------- input

constexpr std::int64_t kMs = 1'000'000;

TEST(InputDelay, IsFromSendingToTheStampAndKnowsWhatWasLost) {
  const InputTrace trace{{{InputDevice::kKey, InputRoute::kQueue, 100 * kMs},
                          {InputDevice::kKey, InputRoute::kQueue, 200 * kMs},
                          {InputDevice::kKey, InputRoute::kQueue, 300 * kMs}},
                         {{InputDevice::kKey, InputRoute::kQueue, 103 * kMs, 4 * kMs},
                          {InputDevice::kKey, InputRoute::kQueue, 301 * kMs, kMs / 2}}};
  const InputDelay found = input_delay(trace, InputDevice::kKey, InputRoute::kQueue);
  EXPECT_EQ(found.sent, 3);
  EXPECT_EQ(found.lost, 1);
  EXPECT_EQ(found.delays_ms, (std::vector<double>{3.0, 1.0}));
  EXPECT_EQ(found.within_uncertainty_share, 0.5);  // 3 within 4 ms, 1 not within half of one
}

TEST(InputDelay, KeepsDevicesAndRoutesApartAndLeavesOutWhatNobodySent) {
  const InputTrace trace{{{InputDevice::kMouse, InputRoute::kWindowSystem, 100 * kMs}},
                         {{InputDevice::kMouse, InputRoute::kWindowSystem, 50 * kMs, kMs},
                          {InputDevice::kKey, InputRoute::kWindowSystem, 101 * kMs, kMs},
                          {InputDevice::kMouse, InputRoute::kQueue, 102 * kMs, kMs},
                          {InputDevice::kMouse, InputRoute::kWindowSystem, 105 * kMs, kMs}}};
  EXPECT_EQ(input_delay(trace, InputDevice::kMouse, InputRoute::kWindowSystem).delays_ms,
            (std::vector<double>{5.0}));
  const InputDelay key = input_delay(trace, InputDevice::kKey, InputRoute::kWindowSystem);
  EXPECT_EQ(key.sent, 0);
  EXPECT_TRUE(key.delays_ms.empty());
}

// ---------------------------------------------------------------- frame content

/// As planned, but what is seen of frame i is the code of frame `seen_frame(i)`.
ContentCheck seen_as(int frames, const std::function<int(int)>& seen_frame) {
  std::vector<PatchSighting> sightings;
  for (int i = 0; i < frames; ++i) {
    sightings.push_back({patch_code(i), patch_code(seen_frame(i))});
  }
  return check_content(sightings);
}

TEST(ContentCheck, FramesAsPlannedPass) {
  const ContentCheck check = seen_as(600, [](int i) { return i; });
  EXPECT_TRUE(check.all_as_planned());
  EXPECT_EQ(check.frames, 600);
  EXPECT_EQ(check.first_wrong, -1);
}

TEST(ContentCheck, OneFrameThatIsTheOneBeforeIsCaughtAndNamed) {
  const ContentCheck check = seen_as(600, [](int i) { return i == 123 ? 122 : i; });
  EXPECT_FALSE(check.all_as_planned());
  EXPECT_EQ(check.wrong, 1);
  EXPECT_EQ(check.first_wrong, 123);
  EXPECT_EQ(check.longest_wrong, 1);
}

TEST(ContentCheck, FramesThatLagByAnyNumberAreCaughtWithinAWord) {
  for (int lag = 1; lag <= 10; ++lag) {
    const ContentCheck check = seen_as(600, [&](int i) { return i < 100 ? i : i - lag; });
    EXPECT_GE(check.first_wrong, 100) << lag;
    EXPECT_LE(check.first_wrong, 100 + kPatchWord) << lag;
    EXPECT_GT(check.wrong, 100) << lag;  // of 500; an odd lag is wrong in every frame
  }
}

TEST(ContentCheck, WhatCannotBeReadIsNotWrongButNotAsPlannedEither) {
  const ContentCheck check = check_content({{3, 3}, {1, std::nullopt}, {3, 3}});
  EXPECT_EQ(check.wrong, 0);
  EXPECT_EQ(check.unreadable, 1);
  EXPECT_FALSE(check.all_as_planned());
  EXPECT_FALSE(check_content({}).all_as_planned());
}

}  // namespace impetus::timing_statistics_test
