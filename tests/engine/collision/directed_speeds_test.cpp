// What spheres on their ways a block rules out at once, against the time of each pair.
// SPDX-License-Identifier: MIT
#include "engine/collision/entry/directed_speeds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/engine/body_of_spheres.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::directed_speeds_test {

constexpr std::uint64_t kSeed = 27;
constexpr double kHair_m = 0.002;

/// (gap + hair) / closing speed; 0 when they overlap.
double time_apart(const Sphere& a, const Sphere& b, const RelativeStretch& stretch,
                  const Pose& at_a, const Pose& at_b) {
  const NodeGap found = gap_of_bounds(a, b);
  const double closing_m = std::max(0.0, -found.normal.dot(stretch.velocity)) +
                           stretch.turn_a * ((a.centre - at_a.position).norm() + a.radius_m) +
                           stretch.turn_b * ((b.centre - at_b.position).norm() + b.radius_m);
  if (found.gap_m <= 0.0) {
    return 0.0;
  }
  return closing_m > 0.0 ? (found.gap_m + kHair_m) / closing_m
                         : std::numeric_limits<double>::infinity();
}

TEST(DirectedSpeeds, WhatIsRuledOutTouchesLaterAndLittleElseIsLeftAtAnyWidth) {
  RandomStream random(kSeed, "blocks");
  int left = 0;
  int left_for_nothing = 0;
  int ruled_out = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    const BodyOfSpheres a(random, {0.15, 0.0, 0.0});
    const BodyOfSpheres b(random, Vector3::Zero());
    RelativeStretch stretch;
    stretch.velocity = random_in_cube(random, 0.3);
    stretch.turn_a = trial % 3 == 0 ? 0.0 : random.uniform();
    stretch.turn_b = trial % 4 == 0 ? 0.0 : random.uniform();
    const BodyPath way;
    DirectedSpeeds near(way, way, a.reach_m, b.reach_m);
    near.enter(stretch);
    near.place(a.pose, b.pose, 0.0);
    const SphereBlock block{{0, 0}, a.spheres.lanes(0), kLanes, b.spheres.lanes(0), kLanes - 1};
    const double time = random.uniform();
    BlockTurning turning{};
    const std::uint64_t bits = near.within(time, kHair_m, block, turning);
    for (const LaneWidth width : {LaneWidth::kTwo, widest_lanes()}) {
      BlockTurning by_width{};
      ASSERT_EQ(near.within(time, kHair_m, block, by_width, width), bits);
      ASSERT_EQ(by_width.a, turning.a);
      ASSERT_EQ(by_width.b, turning.b);
    }
    ASSERT_EQ(bits & ~block.all(), 0U);
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        const Sphere one = sphere_of(block.a, row);
        const Sphere other = sphere_of(block.b, column);
        const double apart = time_apart(one, other, stretch, a.pose, b.pose);
        if ((bits >> (kLanes * row + column) & 1) == 0) {
          ++ruled_out;
          ASSERT_GE(apart, time) << "seed " << kSeed << ", trial " << trial;
        } else {
          ++left;
          left_for_nothing += apart > 1.001 * time ? 1 : 0;
        }
        const double turning_m = turning.a[lane(row)] + turning.b[lane(column)];
        if (near.apart_for(time, kHair_m, one, other, turning_m)) {
          ASSERT_GE(apart, time) << "seed " << kSeed << ", trial " << trial;
        }
      }
    }
  }
  EXPECT_GT(left, 1'000);
  EXPECT_GT(ruled_out, 1'000);
  EXPECT_EQ(left_for_nothing, 0);
}

TEST(DirectedSpeeds, NothingIsRuledOutWhereRoundingCountsOrNumbersCannotBeSquared) {
  RandomStream random(kSeed, "far off");
  const BodyOfSpheres b(random, Vector3::Zero());
  for (const Vector3& about : {Vector3(1e6, 0.0, 0.0), Vector3(1.0, 0.0, 0.0)}) {
    const BodyOfSpheres a(random, about);
    for (const double speed : {1.0, 1e200}) {
      RelativeStretch stretch;
      stretch.velocity = Vector3(-speed, 0.0, 0.0);
      const BodyPath way;
      DirectedSpeeds near(way, way, a.reach_m, b.reach_m);
      near.enter(stretch);
      near.place(a.pose, b.pose, 0.0);
      const SphereBlock block{{0, 0}, a.spheres.lanes(0), kLanes, b.spheres.lanes(0), kLanes};
      BlockTurning turning{};
      const bool all = near.within(1e-9, kHair_m, block, turning) == block.all();
      EXPECT_EQ(all, about.x() > 1e5 || speed > 1.0);
    }
  }
}

}  // namespace impetus::directed_speeds_test
