// What the ways of nodes tell of when they can touch, against where they are at many moments.
// SPDX-License-Identifier: MIT
#include "engine/collision/entry/node_ways.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/engine/body_of_spheres.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::node_ways_test {

constexpr std::uint64_t kSeed = 28;
constexpr double kHair_m = 0.002;
constexpr double kForever = std::numeric_limits<double>::infinity();

/// The first of many moments, until `most`, at which the spheres overlap by more than a hair.
double first_touch(const Sphere& a, const BodyPath& path_a, const Sphere& b, const BodyPath& path_b,
                   double most) {
  const auto centre_at = [](const Sphere& sphere, const BodyPath& path, double time) {
    const Vector3 in_body =
        path.start.orientation.conjugate() * (sphere.centre - path.start.position);
    return pose_at(path, time).transform(in_body);
  };
  constexpr int kMoments = 400;
  for (int moment = 0; moment <= kMoments; ++moment) {
    const double time = most * moment / kMoments;
    const double distance_m = (centre_at(a, path_a, time) - centre_at(b, path_b, time)).norm();
    if (distance_m < a.radius_m + b.radius_m - kHair_m) {
      return time;
    }
  }
  return kForever;
}

/// From a body's pose, over up to 30 cm and turning by up to a third of a radian.
BodyPath some_way(RandomStream& random, const Pose& from, bool turns) {
  BodyPath path{from, {from.position + random_in_cube(random, 0.3), from.orientation}};
  if (turns) {
    const Vector3 turn = random_in_cube(random, 0.1);
    path.end.orientation =
        Quaternion(1.0, turn.x(), turn.y(), turn.z()).normalized() * from.orientation;
  }
  return path;
}

TEST(NodeWays, WhatIsRuledOutDoesNotTouchAndLittleElseIsLeftAtAnyWidth) {
  RandomStream random(kSeed, "blocks");
  int left = 0;
  int left_for_nothing = 0;
  int ruled_out = 0;
  int late = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const BodyOfSpheres a(random, random_in_cube(random, 0.1));
    const BodyOfSpheres b(random, Vector3::Zero());
    const BodyPath path_a = some_way(random, a.pose, trial % 3 != 0);
    const BodyPath path_b = some_way(random, b.pose, trial % 4 != 0);
    NodeWays ways(path_a, path_b, a.reach_m, b.reach_m);
    ways.enter(stretches_of(path_a, path_b)[0]);
    ways.place(a.pose, b.pose, 0.0);
    const SphereBlock block{{0, 0}, a.spheres.lanes(0), kLanes, b.spheres.lanes(0), kLanes - 1};
    const double time = 0.01 + 0.99 * random.uniform();
    BlockWays of_block{};
    const std::uint64_t bits = ways.within(time, kHair_m, block, of_block);
    for (const LaneWidth width : {LaneWidth::kTwo, widest_lanes()}) {
      BlockWays by_width{};
      ASSERT_EQ(ways.within(time, kHair_m, block, by_width, width), bits);
      ASSERT_EQ(by_width.a.x, of_block.a.x);
      ASSERT_EQ(by_width.b.z, of_block.b.z);
      ASSERT_EQ(by_width.b.stray_m, of_block.b.stray_m);
    }
    ASSERT_EQ(bits & ~block.all(), 0U);
    for (int row = 0; row < block.rows; ++row) {
      for (int column = 0; column < block.columns; ++column) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
        const Sphere one = sphere_of(block.a, row);
        const Sphere other = sphere_of(block.b, column);
        const double touch = first_touch(one, path_a, other, path_b, time);
        const NodeWay way = NodeWays::of(of_block, block, row, column);
        ASSERT_EQ(way.velocity, ways.of(one, other).velocity);
        ASSERT_EQ(way.stray_m, ways.of(one, other).stray_m);
        const bool ruled = (bits >> (kLanes * row + column) & 1) == 0;
        ASSERT_EQ(ways.apart_for(time, kHair_m, one, other, way), ruled);
        const NodeGap now = gap_of_bounds(one, other);
        const double until =
            now.gap_m > 0.0 ? NodeWays::time_of_spheres(now.gap_m + kHair_m, now, way, time) : 0.0;
        ASSERT_LE(std::min(until, time), touch);
        if (ruled) {
          ++ruled_out;
          ASSERT_GE(until, time);
          ASSERT_EQ(touch, kForever);
        } else {
          ++left;
          left_for_nothing += touch == kForever && now.gap_m > 0.0 ? 1 : 0;
          late += touch < kForever && now.gap_m > 0.0 && until < 0.5 * touch ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(left, 200);
  EXPECT_GT(ruled_out, 1'000);
  EXPECT_LT(left_for_nothing, left / 4);
  EXPECT_LT(late, left / 20) << "most are foreseen to half of their time, at least";
}

TEST(NodeWays, NothingIsRuledOutWhereRoundingCountsOrNumbersCannotBeSquared) {
  RandomStream random(kSeed, "far off");
  const BodyOfSpheres b(random, Vector3::Zero());
  for (const Vector3& about : {Vector3(1e6, 0.0, 0.0), Vector3(1.0, 0.0, 0.0)}) {
    const BodyOfSpheres a(random, about);
    for (const double speed : {1.0, 1e200}) {
      const BodyPath path_a{a.pose,
                            {a.pose.position + Vector3(speed, 0.0, 0.0), a.pose.orientation}};
      const BodyPath path_b{b.pose, b.pose};
      NodeWays ways(path_a, path_b, a.reach_m, b.reach_m);
      ways.enter(stretches_of(path_a, path_b)[0]);
      ways.place(a.pose, b.pose, 0.0);
      const SphereBlock block{{0, 0}, a.spheres.lanes(0), kLanes, b.spheres.lanes(0), kLanes};
      BlockWays of_block{};
      const bool all = ways.within(1e-9, kHair_m, block, of_block) == block.all();
      EXPECT_EQ(all, about.x() > 1e5 || speed > 1.0);
    }
  }
}

// A look goes as far as bodies turn by half a radian, so that none of it is wasted on a bend.
TEST(NodeWays, ALookEndsWhereBodiesHaveTurnedFar) {
  const BodyPath still{};
  BodyPath turning{};
  turning.end.orientation = Eigen::AngleAxisd(1.8, Vector3::UnitY());
  for (const BodyPath& path : {still, turning}) {
    BodyPath moving = path;
    moving.end.position.x() = 1.0;
    NodeWays ways(moving, still, 1.0, 1.0);
    ways.enter(stretches_of(moving, still)[0]);
    EXPECT_NEAR(ways.horizon(0.8), path.end.orientation.w() < 1.0 ? 0.2 : 0.8, 1e-12);
  }
}

}  // namespace impetus::node_ways_test
