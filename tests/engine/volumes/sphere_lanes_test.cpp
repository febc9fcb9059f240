// Blocks of spheres against spheres one by one: the same bits, whatever the width of the vectors.
// SPDX-License-Identifier: MIT
#include "engine/volumes/sphere_lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "engine/collision/node_pairs.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::sphere_lanes_test {

constexpr std::uint64_t kSeed = 81;

/// Those that this machine has instructions for.
std::vector<LaneWidth> widths() {
  std::vector<LaneWidth> known;
  for (const LaneWidth width : {LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight}) {
    if (width <= widest_lanes()) {
      known.push_back(width);
    }
  }
  return known;
}

/// Spheres of all sizes, some of them alike, touching exactly or points.
SphereArrays random_spheres(RandomStream& random, int count) {
  SphereArrays spheres;
  for (int i = 0; i < count; ++i) {
    Sphere sphere{random_in_cube(random, 1.0), uniform_in(random, 0.0, 1.0)};
    switch (random.below(4)) {
      case 0:
        sphere = {{0.25, 0.5, 0.0}, 0.25};
        break;
      case 1:
        sphere = {{0.25 * static_cast<double>(random.below(4)), 0.5, 0.0}, 0.125};
        break;
      case 2:
        sphere.radius_m = 0.0;
        break;
      default:
        break;
    }
    spheres.add(sphere);
  }
  return spheres;
}

int lanes_below(RandomStream& random) {
  return 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(kLanes)));
}

TEST(SphereLanes, ABlockFindsWhatPairsOneByOneFind) {
  RandomStream random(kSeed, "blocks");
  int found = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    const int rows = lanes_below(random);
    const int columns = lanes_below(random);
    const SphereArrays a = random_spheres(random, rows + 3);
    const SphereArrays b = random_spheres(random, columns + 3);
    std::uint64_t expected = 0;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const bool meet =
            overlap(a.at(static_cast<std::size_t>(row)), b.at(static_cast<std::size_t>(column)));
        expected |= meet ? std::uint64_t{1} << (kLanes * row + column) : 0;
      }
    }
    found += std::popcount(expected);
    for (const LaneWidth width : widths()) {
      ASSERT_EQ(overlaps_of_block(a.lanes(0), rows, b.lanes(0), columns, width), expected)
          << "seed " << kSeed << ", trial " << trial << ", width " << static_cast<int>(width);
    }
  }
  EXPECT_GT(found, 5'000);
}

TEST(SphereLanes, ABlockIsPlacedAsItsSpheresAre) {
  RandomStream random(kSeed, "places");
  for (int trial = 0; trial < 2'000; ++trial) {
    const SphereArrays own = random_spheres(random, kLanes);
    const Pose pose{random_in_cube(random, 10.0), random_turn(random)};
    for (const LaneWidth width : widths()) {
      double x[kLanes];
      double y[kLanes];
      double z[kLanes];
      place_block(own.lanes(0), pose, {x, y, z}, width);
      for (int lane = 0; lane < kLanes; ++lane) {
        const Vector3 expected = pose.transform(own.at(static_cast<std::size_t>(lane)).centre);
        ASSERT_EQ(Vector3(x[lane], y[lane], z[lane]), expected)
            << "seed " << kSeed << ", trial " << trial << ", width " << static_cast<int>(width);
      }
    }
  }
}

TEST(SphereLanes, PairsTouchAsOneByOne) {
  RandomStream random(kSeed, "touches");
  int coincident = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    const SphereArrays a = random_spheres(random, kLanes);
    const SphereArrays b = random_spheres(random, kLanes);
    const Vector3 fallback = random_direction(random);
    SpherePairs pairs{};
    std::vector<TouchPoint> expected;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int other = kLanes - 1 - lane;
      pairs.put(lane, a.lanes(0), lane, b.lanes(0), other);
      const Sphere of_a = a.at(static_cast<std::size_t>(lane));
      const Sphere of_b = b.at(static_cast<std::size_t>(other));
      expected.push_back(touch(of_a, of_b, fallback));
      coincident += of_a.centre == of_b.centre ? 1 : 0;
    }
    for (const LaneWidth width : widths()) {
      TouchPoint touches[kLanes];
      touches_of_pairs(pairs, fallback, touches, width);
      for (int lane = 0; lane < kLanes; ++lane) {
        const TouchPoint& each = expected[static_cast<std::size_t>(lane)];
        ASSERT_EQ(touches[lane].point, each.point) << "trial " << trial;
        ASSERT_EQ(touches[lane].normal, each.normal) << "trial " << trial;
        ASSERT_EQ(touches[lane].depth_m, each.depth_m) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(coincident, 500);
}

TEST(NodePairs, KeepTheOrderInWhichTheyWereFound) {
  RandomStream random(kSeed, "node pairs");
  NodePairs pairs;
  for (int trial = 0; trial < 200; ++trial) {
    pairs.clear();
    std::vector<NodePair> expected;
    for (std::uint64_t blocks = random.below(20); blocks > 0; --blocks) {
      const NodePair first{static_cast<std::int32_t>(random.below(1'000)),
                           static_cast<std::int32_t>(random.below(1'000))};
      std::uint64_t bits = 0;
      for (int bit = 0; bit < kLanes * kLanes; ++bit) {
        if (random.below(5) == 0) {
          bits |= std::uint64_t{1} << bit;
          expected.push_back({first.a + bit / kLanes, first.b + bit % kLanes});
        }
      }
      pairs.add_block(first, bits);
      if (random.below(2) == 0) {
        pairs.add(first);
        expected.push_back(first);
      }
    }
    ASSERT_EQ(pairs.size(), expected.size());
    ASSERT_TRUE(std::equal(pairs.begin(), pairs.end(), expected.begin(), expected.end()));
    std::vector<NodePair> of_blocks;
    for (const NodeBlock& block : pairs.blocks()) {
      for (int bit = 0; bit < kLanes * kLanes; ++bit) {
        if ((block.bits >> bit & 1) != 0) {
          of_blocks.push_back({block.first.a + bit / kLanes, block.first.b + bit % kLanes});
        }
      }
    }
    ASSERT_EQ(of_blocks, expected);
    std::vector<NodePair> stepped;
    for (NodePairs::Place place = pairs.first(); !pairs.is_end(place); place = pairs.after(place)) {
      stepped.push_back(pairs.at(place));
    }
    ASSERT_EQ(stepped, expected);
  }
}

}  // namespace impetus::sphere_lanes_test
