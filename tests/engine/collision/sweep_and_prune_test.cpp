// Sweep and prune against all pairs: the same pairs in the same order, whatever was swept before.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/collision/broad_phase.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::sweep_and_prune_test {

constexpr std::uint64_t kSeed = 62;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<MovedBound> any_bounds(RandomStream& random, std::size_t count) {
  std::vector<MovedBound> bounds;
  for (std::size_t i = 0; i < count; ++i) {
    bounds.push_back({{random_in_cube(random, 2.0), uniform_in(random, 0.0, 0.6)},
                      random.below(3) == 0 ? uniform_in(random, 0.0, 0.5) : 0.0,
                      random.below(4) != 0});
  }
  return bounds;
}

/// Whether both find the same; the number of pairs is added to `found`.
bool agree(SweepAndPrune& sweep, const std::vector<MovedBound>& bounds, std::size_t& found) {
  const std::vector<PairBounds> expected = candidate_pairs(bounds);
  const std::vector<PairBounds> swept = sweep.candidates(bounds);
  found += expected.size();
  if (swept.size() != expected.size()) {
    return false;
  }
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const auto a = static_cast<std::size_t>(swept[i].pair.a);
    if (!(swept[i].pair == expected[i].pair) || !(swept[i].a.centre == bounds[a].bound.centre)) {
      return false;
    }
  }
  return true;
}

TEST(SweepAndPrune, FindsWhatAllPairsFindWhileBodiesMove) {
  RandomStream random(kSeed, "moving bounds");
  std::size_t found = 0;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<MovedBound> bounds = any_bounds(random, 2 + random.below(40));
    SweepAndPrune sweep;
    for (int step = 0; step < 50; ++step) {
      ASSERT_TRUE(agree(sweep, bounds, found)) << "seed " << kSeed << ", trial " << trial;
      for (MovedBound& bound : bounds) {
        const Vector3 way = random_in_cube(random, 0.1);
        bound.bound.centre += way;
        bound.travelled_m = way.norm();
      }
    }
  }
  EXPECT_GT(found, 10'000U);
}

TEST(SweepAndPrune, FindsWhatAllPairsFindAfterTeleportsAndChangesOfNumber) {
  RandomStream random(kSeed, "teleports");
  SweepAndPrune sweep;
  std::size_t found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ASSERT_TRUE(agree(sweep, any_bounds(random, random.below(60)), found)) << "seed " << kSeed;
  }
  for (const std::size_t count : {0U, 1U, 2U, 1U, 0U}) {
    ASSERT_TRUE(agree(sweep, any_bounds(random, count), found));
  }
  EXPECT_GT(found, 1'000U);
}

TEST(SweepAndPrune, BodiesInOnePlaceOrJustTouchingAreNotMissed) {
  SweepAndPrune sweep;
  std::size_t found = 0;
  EXPECT_TRUE(agree(sweep, std::vector<MovedBound>(20, {{Vector3::Zero(), 0.0}}), found));
  EXPECT_EQ(found, 190U) << "points in one place touch";
  RandomStream random(kSeed, "touching");
  for (int trial = 0; trial < 2'000; ++trial) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
    const Vector3 place = scale * random_in_cube(random, 3.0);
    const double a_m = scale * random.uniform();
    const double b_m = scale * random.uniform();
    const Vector3 away = (a_m + b_m) * Vector3::Unit(static_cast<int>(random.below(3)));
    ASSERT_TRUE(agree(sweep, {{{place, a_m}}, {{place + away, b_m}}}, found)) << "seed " << kSeed;
  }
  EXPECT_GT(found, 1'000U);
}

TEST(SweepAndPrune, WhatAllPairsMakeOfHugeTinyAndUndefinedNumbersItDoesToo) {
  RandomStream random(kSeed, "extremes");
  const double extremes[] = {0.0,    -0.0,  1e-320, 1e-170, 1e-150,    -1e-200,    1e150,
                             -1e160, 1e200, 1e308,  -1e308, kInfinity, -kInfinity, std::nan("")};
  const auto any_extreme = [&] { return extremes[random.below(std::size(extremes))]; };
  SweepAndPrune sweep;
  std::size_t found = 0;
  for (int trial = 0; trial < 3'000; ++trial) {
    std::vector<MovedBound> bounds = any_bounds(random, 2 + random.below(8));
    for (MovedBound& bound : bounds) {
      for (double* number :
           {&bound.bound.centre.x(), &bound.bound.centre.y(), &bound.bound.centre.z()}) {
        *number = random.below(4) == 0 ? any_extreme() : *number;
      }
      bound.bound.radius_m = random.below(6) == 0 ? std::abs(any_extreme()) : bound.bound.radius_m;
      bound.travelled_m = random.below(6) == 0 ? std::abs(any_extreme()) : bound.travelled_m;
    }
    const std::vector<PairBounds> expected = candidate_pairs(bounds);
    const std::vector<PairBounds> swept = sweep.candidates(bounds);
    ASSERT_EQ(swept.size(), expected.size()) << "seed " << kSeed << ", trial " << trial;
    for (std::size_t i = 0; i < swept.size(); ++i) {
      ASSERT_EQ(swept[i].pair, expected[i].pair) << "seed " << kSeed << ", trial " << trial;
    }
    found += expected.size();
  }
  EXPECT_GT(found, 1'000U);
}

TEST(SweepAndPrune, ManyBodiesAreSweptInStripsAndEachPairIsFoundOnce) {
  RandomStream random(kSeed, "strips");
  SweepAndPrune sweep;
  std::size_t found = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double spread = uniform_in(random, 0.5, 12.0);
    const double flat = random.below(3) == 0 ? 0.0 : 1.0;
    std::vector<MovedBound> bounds = any_bounds(random, 100 + random.below(300));
    for (MovedBound& bound : bounds) {
      bound.bound.centre *= spread;
      bound.bound.centre[static_cast<int>(random.below(3))] *= flat;
      if (random.below(100) == 0) {
        bound.bound.radius_m = random.below(2) == 0 ? kInfinity : 1e6;
      }
    }
    ASSERT_TRUE(agree(sweep, bounds, found)) << "seed " << kSeed << ", trial " << trial;
  }
  EXPECT_GT(found, 10'000U);
}

/// How many blocks a sweep along the axis compares that does not part its bodies.
std::int64_t blocks_without_strips(const std::vector<MovedBound>& bounds, int axis) {
  std::vector<double> least;
  for (const MovedBound& each : bounds) {
    least.push_back(each.bound.centre[axis] - each.bound.radius_m);
  }
  std::sort(least.begin(), least.end());
  std::int64_t blocks = 0;
  for (std::size_t i = 0; i < least.size(); ++i) {
    const double greatest = least[i] + 2.0 * bounds[0].bound.radius_m;
    const auto behind = least.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    blocks += (std::upper_bound(behind, least.end(), greatest) - behind + kLanes - 1) / kLanes;
  }
  return blocks;
}

TEST(SweepAndPrune, StripsSpareMostOfTheSweepAlongAnyAxis) {
  RandomStream random(kSeed, "a wide room");
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<MovedBound> bounds;
    for (int i = 0; i < 2'000; ++i) {
      bounds.push_back({{random_in_cube(random, 10.0), 0.3}, 0.0});
      bounds.back().bound.centre[axis] *= 1.5;
    }
    FixedWork meter(WorkGrants{});
    WorkGrants granted;
    PhaseWork work(meter, WorkPhase::kSweep, granted);
    std::vector<BodyPair> pairs;
    SweepAndPrune().find(bounds, pairs, &work);
    EXPECT_FALSE(work.refused());
    EXPECT_LT(work.done(), blocks_without_strips(bounds, axis) / 2) << "axis " << axis;
  }
}

TEST(SweepAndPrune, TwoImmovableBodiesNeverPair) {
  SweepAndPrune sweep;
  const MovedBound fixed{{Vector3::Zero(), 1.0}, 0.0, false};
  EXPECT_TRUE(sweep.candidates({fixed, fixed}).empty());
  EXPECT_EQ(sweep.candidates({fixed, {{Vector3::Zero(), 1.0}}, fixed}).size(), 2U);
}

TEST(SweepAndPrune, AStoppedSweepHasFoundThoseThatBeginNearestBehindEach) {
  constexpr std::size_t kBalls = 200;
  std::vector<MovedBound> bounds;
  for (std::size_t i = 0; i < kBalls; ++i) {  // each meets the 39 behind it
    bounds.push_back({{Vector3{static_cast<double>(i), 0.0, 0.0}, 19.75}, 0.0});
  }
  // A round compares each ball with a block of those behind it, and finds all of them.
  const std::int64_t round = (kLanes + 1) * kBalls;
  WorkGrants grants;
  grants.of(WorkPhase::kSweep) = round;
  FixedWork meter(grants);
  WorkGrants granted;
  PhaseWork work(meter, WorkPhase::kSweep, granted);
  std::vector<BodyPair> pairs;
  SweepAndPrune().find(bounds, pairs, &work);
  EXPECT_TRUE(work.refused());
  for (std::size_t i = 0; i + kLanes < kBalls; ++i) {
    for (std::size_t behind = 1; behind <= kLanes; ++behind) {
      const BodyPair near{static_cast<std::int32_t>(i), static_cast<std::int32_t>(i + behind)};
      ASSERT_EQ(std::count(pairs.begin(), pairs.end(), near), 1) << i << " and " << behind;
    }
  }
  EXPECT_LE(pairs.size(), static_cast<std::size_t>(round));
  EXPECT_LT(pairs.size(), candidate_pairs(bounds).size() / 3);
}

TEST(SweepAndPrune, ACopiedWorldResumesBitForBit) {
  RandomStream random(kSeed, "snapshots");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    World whole = random_tree_world(seed, 4);
    const std::uint64_t copied_at = random.below(60);
    std::optional<World> copy;
    for (std::uint64_t step = 0; step < 80; ++step) {
      if (step == copied_at) {
        copy = whole;
      }
      const std::uint64_t hash = step_whole(whole).state.hash;
      if (copy) {
        ASSERT_EQ(step_whole(*copy).state.hash, hash) << "world " << seed << ", step " << step;
      }
    }
    EXPECT_TRUE(copy);
  }
}

}  // namespace impetus::sweep_and_prune_test
