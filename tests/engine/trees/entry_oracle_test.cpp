// The search for an entry against the plain one: the same to the last bit, the tests counted
// included, by the rules of today and of recording formats below 7. By those of 7, which begin each
// look with the nearest nodes, the same as before by fewer tests; by those of today by far fewer.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/plain_entry.hpp"
#include "tests/engine/shots.hpp"

namespace impetus::entry_oracle_test {

constexpr std::uint64_t kSeed = 174;

/// Two bodies on their ways, with what the ways need to be random about.
struct Meeting {
  const VolumeTree& a;
  const VolumeTree& b;
  BodyPath path_a;
  BodyPath path_b;
  int greatest_level{kUnlimitedLevel};
  std::int64_t most_tests{kMostEntryTests};
};

/// From somewhere about the other body to somewhere about it, now and then waiting or stopped.
BodyPath random_way(RandomStream& random, double from_m, double to_m) {
  BodyPath path{{from_m * random_direction(random), random_turn(random)},
                {random_in_cube(random, to_m), random_turn(random)}};
  if (random.below(2) == 0) {  // a small turn, as in most steps
    const Vector3 turn = random_in_cube(random, 0.05);
    const Quaternion small = Quaternion(1.0, turn.x(), turn.y(), turn.z()).normalized();
    path.end.orientation = small * path.start.orientation;
  }
  path.begin = random.below(3) == 0 ? 0.5 * random.uniform() : 0.0;
  path.stop =
      random.below(3) == 0 ? path.begin + (1.0 - path.begin) * (0.1 + 0.9 * random.uniform()) : 1.0;
  return path;
}

struct Found {
  Entry entry;
  Pose pose_a;
  Pose pose_b;
};

template <typename Search>
Found found(const Meeting& meeting, const Search& search, EntryRules rules) {
  PlacedTree a(meeting.a);
  PlacedTree b(meeting.b);
  const Entry entry =
      search(PairOnTheWay{a, b, meeting.path_a, meeting.path_b, meeting.greatest_level,
                          meeting.most_tests, /*work=*/nullptr, rules});
  return {entry, a.pose(), b.pose()};
}

bool same_bits(const Vector3& x, const Vector3& y) { return (x.array() == y.array()).all(); }

bool same_bits(const Pose& x, const Pose& y) {
  return same_bits(x.position, y.position) && x.orientation.coeffs() == y.orientation.coeffs();
}

/// What a number of comparisons found, so that none of it is vacuous.
struct Outcomes {
  int entries{0};
  int misses{0};
  int interrupted{0};
  std::int64_t tests{0};          ///< by the rules of today
  std::int64_t directed{0};       ///< tests by the rules of formats below 7, of those that end ...
  std::int64_t nearest_first{0};  ///< ... by themselves by those of 7, too, and theirs
  std::int64_t all_directed{0};   ///< of all by the rules of formats below 7

  void add(const Outcomes& other) {
    entries += other.entries;
    misses += other.misses;
    interrupted += other.interrupted;
    tests += other.tests;
    directed += other.directed;
    nearest_first += other.nearest_first;
    all_directed += other.all_directed;
  }
};

/// What the search finds, which is what the plain one does.
Found found_alike(const Meeting& meeting, EntryRules rules) {
  const Found plain = found(meeting, plain::time_of_entry, rules);
  const Found fast = found(meeting, time_of_entry, rules);
  EXPECT_EQ(fast.entry.time, plain.entry.time);
  EXPECT_EQ(fast.entry.tests, plain.entry.tests);
  EXPECT_TRUE(same_bits(fast.pose_a, plain.pose_a) && same_bits(fast.pose_b, plain.pose_b));
  return fast;
}

/// Compares the searches with the plain ones, and those of all rules with each other.
void compare(const Meeting& meeting, int trial, Outcomes& outcomes) {
  SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
  const Found today = found_alike(meeting, EntryRules::kNodeWays);
  ++(today.entry.time ? outcomes.entries : outcomes.misses);
  outcomes.interrupted += today.entry.tests < meeting.most_tests ? 0 : 1;
  outcomes.tests += today.entry.tests;
  const Found directed = found_alike(meeting, EntryRules::kDirected);
  outcomes.all_directed += directed.entry.tests;
  const Found nearest = found(meeting, time_of_entry, EntryRules::kNearestFirst);
  if (directed.entry.tests < meeting.most_tests && nearest.entry.tests < meeting.most_tests) {
    EXPECT_EQ(nearest.entry.time, directed.entry.time);
    EXPECT_TRUE(same_bits(nearest.pose_a, directed.pose_a) &&
                same_bits(nearest.pose_b, directed.pose_b));
    outcomes.directed += directed.entry.tests;
    outcomes.nearest_first += nearest.entry.tests;
  }
}

Outcomes compared_on_random_ways(RandomStream& random, const VolumeTree& a, const VolumeTree& b,
                                 int trials) {
  const double size_m = a.bounding_radius_m() + b.bounding_radius_m();
  Outcomes outcomes;
  for (int trial = 0; trial < trials; ++trial) {
    const double from_m = size_m * uniform_in(random, 0.2, 1.5);
    const double to_m = size_m * uniform_in(random, 0.1, 1.5);
    Meeting meeting{a, b, random_way(random, from_m, to_m), random_way(random, 0.3 * size_m, 0.3)};
    if (random.below(3) == 0) {  // as much as a crowd moves in a step
      meeting.path_a.end.position =
          meeting.path_a.start.position + random_in_cube(random, 0.2 * size_m);
      meeting.path_b.end.position = meeting.path_b.start.position;
    }
    meeting.greatest_level =
        random.below(2) == 0 ? static_cast<int>(random.below(4)) : kUnlimitedLevel;
    meeting.most_tests = random.below(3) == 0 ? 1 + static_cast<std::int64_t>(random.below(200))
                                              : std::int64_t{2'000};
    compare(meeting, trial, outcomes);
  }
  return outcomes;
}

TEST(EntryOracle, SearchesOfRandomSphereTreesAreThoseOfThePlainOne) {
  RandomStream random(kSeed, "random trees");
  Outcomes all;
  for (int tree = 0; tree < 60; ++tree) {
    const VolumeTree a = random_tree(random, 5);
    const VolumeTree b = random_tree(random, 4);
    all.add(compared_on_random_ways(random, a, b, 30));
  }
  EXPECT_GT(all.entries, 100);
  EXPECT_GT(all.misses, 100);
  EXPECT_GT(all.interrupted, 100);
  EXPECT_LT(10 * all.nearest_first, 9 * all.directed) << "a tenth fewer tests, at least";
  EXPECT_LT(2 * all.tests, all.all_directed) << "half as many, at most";
}

class EntriesOfKind : public testing::TestWithParam<const char*> {};

TEST_P(EntriesOfKind, AreThoseOfThePlainSearchAgainstEveryOtherKind) {
  RandomStream random(kSeed, "kinds");
  const TreeSettings settings{tree_kind(GetParam()), 2, 8};
  const VolumeTree a = build_tree(small_l_block(), settings);
  const VolumeTree spheres = build_tree(small_l_block(), {TreeKind::kOctree, 3, 8});
  const Outcomes all = compared_on_random_ways(random, a, a, 60);
  const Outcomes with_spheres = compared_on_random_ways(random, spheres, a, 60);
  EXPECT_GT(all.entries, 5);
  EXPECT_GT(with_spheres.entries, 5);
  EXPECT_GT(all.tests + with_spheres.tests, 2'000);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EntriesOfKind,
                         testing::Values("octree", "medial", "voxel", "box", "swept",
                                         "heterogeneous"),
                         [](const auto& kind) { return std::string(kind.param); });

/// A sphere of spheres, more than a block of them at every node.
VolumeTree broad_tree(RandomStream& random, int children) {
  std::vector<VolumeNode> nodes{{Sphere{Vector3::Zero(), 1.0}, 1, children, {}}};
  for (int child = 0; child < children; ++child) {
    nodes.push_back(
        {Sphere{0.8 * random_direction(random), uniform_in(random, 0.1, 0.19)}, 0, 0, {}});
  }
  return {std::move(nodes), {0, 1}};
}

TEST(EntryOracle, NodesOfMoreChildrenThanABlockHoldsAreSearchedInTheSameOrder) {
  RandomStream random(kSeed, "broad trees");
  Outcomes all;
  for (int tree = 0; tree < 20; ++tree) {
    const VolumeTree a = broad_tree(random, 1 + static_cast<int>(random.below(20)));
    const VolumeTree b = broad_tree(random, 9 + static_cast<int>(random.below(20)));
    all.add(compared_on_random_ways(random, a, b, 30));
  }
  EXPECT_GT(all.entries, 30);
  EXPECT_GT(all.misses, 30);
}

TEST(EntryOracle, WhatNoBoundHoldsOfIsSearchedAlike) {
  RandomStream random(kSeed, "odd poses");
  const VolumeTree tree = random_tree(random, 4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int trial = 0; trial < 40; ++trial) {
    for (int odd = 0; odd < 4; ++odd) {
      Meeting meeting{tree, tree, random_way(random, 2.0, 1.0), random_way(random, 0.5, 0.5)};
      if (odd == 0) {
        meeting.path_a.start.position.x() = nan;
      } else if (odd == 1) {
        meeting.path_a.start.orientation.coeffs() *= 3.0;  // it stretches the body
      } else if (odd == 2) {
        const Vector3 far(1e9, -1e9, 1e9);
        for (Pose* pose : {&meeting.path_a.start, &meeting.path_a.end, &meeting.path_b.start,
                           &meeting.path_b.end}) {
          pose->position += far;
        }
      } else {
        meeting.path_a.end.position *= 1e12;
      }
      for (const EntryRules rules : {EntryRules::kDirected, EntryRules::kNodeWays}) {
        const Entry plain = found(meeting, plain::time_of_entry, rules).entry;
        const Entry fast = found(meeting, time_of_entry, rules).entry;
        ASSERT_EQ(fast.time, plain.time) << "seed " << kSeed << ", trial " << trial << ", " << odd;
        ASSERT_EQ(fast.tests, plain.tests)
            << "seed " << kSeed << ", trial " << trial << ", " << odd;
      }
    }
  }
}

}  // namespace impetus::entry_oracle_test
