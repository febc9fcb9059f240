// Collision: candidates against all pairs, refinement against brute force, and contacts.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/collision/broad_phase.hpp"
#include "engine/collision/contact_model.hpp"
#include "engine/collision/pair_refinement.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::collision_test {

constexpr std::uint64_t kSeed = 20'02;
using Answer = std::set<std::pair<std::int32_t, std::int32_t>>;

/// The pairs as they are listed.
std::vector<NodePair> list_of(const NodePairs& pairs) { return {pairs.begin(), pairs.end()}; }

Answer as_set(const NodePairs& pairs) {
  Answer answer;
  for (const NodePair& pair : pairs) {
    EXPECT_TRUE(answer.emplace(pair.a, pair.b).second) << "a node pair is listed twice";
  }
  return answer;
}

/// The oracle: every node of one level against every node of the other, no descent. Equal to the
/// descent because children of random_tree() lie within their parents.
Answer brute_force(PlacedTree& a, PlacedTree& b, int level) {
  Answer answer;
  for (const std::int32_t i : a.tree().standing_at(level)) {
    for (const std::int32_t j : b.tree().standing_at(level)) {
      if (overlap(a.world_volume(i), b.world_volume(j))) {
        answer.emplace(i, j);
      }
    }
  }
  return answer;
}

/// Two placed trees of up to four levels each, near enough to overlap at the root.
struct TwoTrees {
  explicit TwoTrees(RandomStream& random)
      : tree_a(random_tree(random, 1 + static_cast<int>(random.below(5)))),
        tree_b(random_tree(random, 1 + static_cast<int>(random.below(5)))),
        a(tree_a),
        b(tree_b) {
    a.move_to({random_in_cube(random, 0.3), random_turn(random)});
    b.move_to({uniform_in(random, 0.2, 1.9) * random_direction(random), random_turn(random)});
  }
  TwoTrees(const TwoTrees&) = delete;
  TwoTrees& operator=(const TwoTrees&) = delete;

  VolumeTree tree_a;
  VolumeTree tree_b;
  PlacedTree a;
  PlacedTree b;
};

/// Refines until the next block would exceed `tests`; returns the tests spent. What is left over
/// is the caller's to add to the next grant.
std::int64_t spend(PairRefinement& pair, std::int64_t tests) {
  std::int64_t spent = 0;
  while (!pair.resolved() && spent + pair.next_block() <= tests) {
    spent += pair.next_block();
    pair.refine_one_block();
  }
  return spent;
}

PairRefinement refined_to_the_end(TwoTrees& trees) {
  PairRefinement pair(trees.a, trees.b);
  spend(pair, kUnlimitedTests);
  return pair;
}

TEST(PairRefinement, EveryCommittedLevelEqualsBruteForceOverThatLevel) {
  RandomStream random(kSeed, "levels");
  int deepest = 0;
  for (int trial = 0; trial < 400; ++trial) {
    TwoTrees trees(random);
    PairRefinement pair(trees.a, trees.b);
    int checked = -1;
    while (true) {
      if (pair.level() != checked) {
        checked = pair.level();
        ASSERT_EQ(as_set(pair.overlapping()), brute_force(trees.a, trees.b, checked))
            << "seed " << kSeed << ", trial " << trial << ", level " << checked;
      }
      if (pair.resolved()) {
        break;
      }
      pair.refine_one_block();
    }
    deepest = std::max(deepest, checked);
  }
  EXPECT_GE(deepest, 4) << "the random trees never reached the depth they were made for";
}

TEST(PairRefinement, FinestLevelEqualsBruteForceOverAllLeafPairs) {
  RandomStream random(kSeed, "leaves");
  int contacts = 0;
  for (int trial = 0; trial < 400; ++trial) {
    TwoTrees trees(random);
    const PairRefinement pair = refined_to_the_end(trees);
    ASSERT_EQ(as_set(pair.overlapping()), brute_force(trees.a, trees.b, /*level=*/5))
        << "seed " << kSeed << ", trial " << trial;
    EXPECT_EQ(pair.stop_reason(),
              pair.overlapping().empty() ? StopReason::kSeparated : StopReason::kFinest);
    contacts += static_cast<int>(pair.overlapping().size());
  }
  EXPECT_GT(contacts, 1'000) << "the random trees hardly ever met";
}

TEST(PairRefinement, InterruptedThenResumedEqualsUninterruptedForEverySlicing) {
  RandomStream random(kSeed, "slices");
  for (int trial = 0; trial < 150; ++trial) {
    TwoTrees trees(random);
    const PairRefinement whole = refined_to_the_end(trees);
    for (const std::int64_t slice : {1, 2, 3, 5, 8, 17, 64}) {
      PairRefinement sliced(trees.a, trees.b);
      std::int64_t unspent = 0;
      while (!sliced.resolved()) {
        unspent += slice;
        unspent -= spend(sliced, unspent);
        ASSERT_EQ(as_set(sliced.overlapping()), brute_force(trees.a, trees.b, sliced.level()));
      }
      ASSERT_EQ(sliced.overlapping(), whole.overlapping()) << "trial " << trial << ", " << slice;
      ASSERT_EQ(sliced.level(), whole.level());
    }
  }
}

TEST(PairRefinement, ACopyTakenAtAnyBlockFinishesAlike) {
  RandomStream random(kSeed, "copies");
  for (int trial = 0; trial < 60; ++trial) {
    TwoTrees trees(random);
    const PairRefinement whole = refined_to_the_end(trees);
    PairRefinement pair(trees.a, trees.b);
    while (!pair.resolved()) {
      PairRefinement copy = pair;
      spend(copy, kUnlimitedTests);
      ASSERT_EQ(copy.overlapping(), whole.overlapping()) << "trial " << trial;
      pair.refine_one_block();
    }
  }
}

TEST(PairRefinement, RefiningOtherPairsInBetweenChangesNothing) {
  RandomStream random(kSeed, "interleaved");
  for (int trial = 0; trial < 100; ++trial) {
    TwoTrees trees(random);
    const PairRefinement whole = refined_to_the_end(trees);
    PairRefinement pair(trees.a, trees.b);
    PairRefinement mirrored(trees.b, trees.a);
    while (!pair.resolved()) {
      pair.refine_one_block();
      if (!mirrored.resolved()) {
        mirrored.refine_one_block();
      }
    }
    ASSERT_EQ(pair.overlapping(), whole.overlapping());
  }
}

TEST(PairRefinement, SwappingTheTreesSwapsTheAnswer) {
  RandomStream random(kSeed, "swapped");
  for (int trial = 0; trial < 100; ++trial) {
    TwoTrees trees(random);
    PairRefinement swapped(trees.b, trees.a);
    spend(swapped, kUnlimitedTests);
    Answer turned;
    for (const NodePair& pair : swapped.overlapping()) {
      turned.emplace(pair.b, pair.a);
    }
    ASSERT_EQ(as_set(refined_to_the_end(trees).overlapping()), turned);
  }
}

TEST(PairRefinement, SeparatedMeansThatNoLeavesOverlap) {
  RandomStream random(kSeed, "separated");
  int separated = 0;
  for (int trial = 0; trial < 400; ++trial) {
    TwoTrees trees(random);
    PairRefinement pair(trees.a, trees.b);
    while (!pair.resolved()) {
      pair.refine_one_block();
    }
    if (pair.stop_reason() == StopReason::kSeparated) {
      ++separated;
      ASSERT_TRUE(brute_force(trees.a, trees.b, 5).empty()) << "trial " << trial;
    }
  }
  EXPECT_GT(separated, 20);
}

TEST(PairRefinement, ALeafAgainstAnInnerNodeDescendsTheInnerNode) {
  const VolumeTree sphere = single_node_tree(Sphere{Vector3::Zero(), 0.5});
  const VolumeTree pair_of_spheres = two_levels({{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}}, 0.75, 2.0);
  PlacedTree a(sphere);
  PlacedTree b(pair_of_spheres);
  a.move_to({Vector3(1.5, 0.0, 0.0), Quaternion::Identity()});
  PairRefinement pair(a, b);
  EXPECT_EQ(list_of(pair.overlapping()), (std::vector<NodePair>{{0, 0}}));
  EXPECT_EQ(pair.next_block(), 2);
  EXPECT_EQ(pair.stop_reason(), StopReason::kBudgetSpent);
  pair.refine_one_block();
  EXPECT_EQ(list_of(pair.overlapping()), (std::vector<NodePair>{{0, 1}}));
  EXPECT_EQ(pair.level(), 1);
  EXPECT_EQ(pair.stop_reason(), StopReason::kFinest);
}

/// What the next level takes: a test of each two children, none of two leaves.
std::int64_t tests_below(const TwoTrees& trees, const NodePairs& pairs) {
  std::int64_t tests = 0;
  for (const NodePair& pair : pairs) {
    const std::int32_t of_a = trees.tree_a.links(pair.a).child_count;
    const std::int32_t of_b = trees.tree_b.links(pair.b).child_count;
    tests += of_a + of_b > 0 ? std::int64_t{std::max(of_a, 1)} * std::max(of_b, 1) : 0;
  }
  return tests;
}

TEST(PairRefinement, OfUnevenTreesPairsOfLeavesCostNothing) {
  RandomStream random(kSeed, "leaves");
  int levels = 0;
  for (int trial = 0; trial < 100; ++trial) {
    TwoTrees trees(random);
    PairRefinement pair(trees.a, trees.b);
    while (!pair.resolved()) {
      const std::int64_t expected = tests_below(trees, pair.overlapping());
      ASSERT_EQ(pair.tests_of_next_level(), expected) << "seed " << kSeed << ", trial " << trial;
      std::int64_t spent = 0;
      for (const int level = pair.level(); pair.level() == level; pair.refine_one_block()) {
        ASSERT_LE(pair.next_block(), pair.most_found_after_next_block());
        spent += pair.next_block();
      }
      ASSERT_EQ(spent, expected) << "seed " << kSeed << ", trial " << trial;
      ++levels;
    }
  }
  EXPECT_GT(levels, 100);
}

TEST(PairRefinement, TwoSpheresAreResolvedByTheFirstTest) {
  const VolumeTree sphere = single_node_tree(Sphere{Vector3::Zero(), 0.5});
  PlacedTree a(sphere);
  PlacedTree b(sphere);
  b.move_to({Vector3(1.0, 0.0, 0.0), Quaternion::Identity()});
  EXPECT_EQ(PairRefinement(a, b).stop_reason(), StopReason::kFinest);
  EXPECT_EQ(PairRefinement(a, b).next_block(), 0);
  b.move_to({Vector3(1.5, 0.0, 0.0), Quaternion::Identity()});
  EXPECT_EQ(PairRefinement(a, b).stop_reason(), StopReason::kSeparated);
  EXPECT_TRUE(PairRefinement(a, b).resolved());
}

TEST(PairRefinement, AnUnfinishedLevelIsNotShown) {
  // Two children each: the roots' block is 4 tests; each of up to four pairs then needs its own.
  RandomStream random(kSeed, "unfinished");
  for (int trial = 0; trial < 100; ++trial) {
    TwoTrees trees(random);
    PairRefinement pair(trees.a, trees.b);
    while (!pair.resolved()) {
      const int level = pair.level();
      const NodePairs shown = pair.overlapping();
      pair.refine_one_block();
      if (pair.level() == level) {
        ASSERT_EQ(pair.overlapping(), shown);
      } else {
        ASSERT_EQ(pair.level(), level + 1);
      }
    }
  }
}

TEST(PlacedTree, NodesOfAnOldPoseAreNeverSeenAgain) {
  RandomStream random(kSeed, "placed");
  const VolumeTree tree = random_tree(random, 4);
  PlacedTree placed(tree);
  for (int step = 0; step < 20; ++step) {
    const Pose pose{random_in_cube(random, 5.0), random_turn(random)};
    placed.move_to(pose);
    for (std::int32_t index = 0; index < tree.node_count(); ++index) {
      const auto volume = std::get<Sphere>(tree.volume(index));
      ASSERT_EQ(placed.world_sphere(index).centre, pose.transform(volume.centre));
      ASSERT_EQ(placed.world_sphere(index).radius_m, volume.radius_m);
    }
  }
}

TEST(BroadPhase, FindsEveryPairOfMovableBoundsThatOverlap) {
  RandomStream random(kSeed, "broad phase");
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<MovedBound> bodies;
    for (int body = 0; body < 20; ++body) {
      bodies.push_back({{random_in_cube(random, 2.0), uniform_in(random, 0.1, 0.8)},
                        uniform_in(random, 0.0, 0.2),
                        random.below(3) > 0});
    }
    const std::vector<PairBounds> found = candidate_pairs(bodies);
    std::vector<BodyPair> pairs;
    for (const PairBounds& each : found) {
      ASSERT_LT(each.pair.a, each.pair.b);
      pairs.push_back(each.pair);
    }
    for (std::int32_t b = 1; b < 20; ++b) {
      for (std::int32_t a = 0; a < b; ++a) {
        const MovedBound& x = bodies[static_cast<std::size_t>(a)];
        const MovedBound& y = bodies[static_cast<std::size_t>(b)];
        const double reach = x.bound.radius_m + y.bound.radius_m + x.travelled_m + y.travelled_m;
        const bool near = (x.bound.centre - y.bound.centre).norm() <= reach;
        const bool listed = std::count(pairs.begin(), pairs.end(), BodyPair{a, b}) == 1;
        ASSERT_EQ(listed, near && (x.movable || y.movable)) << trial << ": " << a << ", " << b;
      }
    }
  }
}

TEST(BroadPhase, NeverPairsTwoStaticBodies) {
  const MovedBound wall{{Vector3::Zero(), 1.0}, 0.0, false};
  EXPECT_TRUE(candidate_pairs({wall, wall}).empty());
}

TEST(ContactModel, OneNodePairGivesTheContactOfTwoSpheres) {
  const VolumeTree sphere = single_node_tree(Sphere{Vector3::Zero(), 0.5});
  PlacedTree a(sphere);
  PlacedTree b(sphere);
  b.move_to({Vector3(0.75, 0.0, 0.0), Quaternion::Identity()});
  const Contact contact = average_contact({3, 7}, PairRefinement(a, b), a, b, {});
  EXPECT_EQ(contact.bodies, (BodyPair{3, 7}));
  EXPECT_EQ(contact.touch.normal, Vector3(-1.0, 0.0, 0.0));
  EXPECT_EQ(contact.touch.point, Vector3(0.375, 0.0, 0.0));
  EXPECT_EQ(contact.touch.depth_m, 0.25);
}

TEST(ContactModel, SeveralNodePairsAreAveraged) {
  // A ball above two balls: the normals lean outwards alike and average to the vertical.
  const VolumeTree sphere = single_node_tree(Sphere{Vector3::Zero(), 1.0});
  const VolumeTree twins = two_levels({{0.5, 0.0, 0.0}, {-0.5, 0.0, 0.0}}, 1.0, 2.0);
  PlacedTree a(sphere);
  PlacedTree b(twins);
  a.move_to({Vector3(0.0, 1.5, 0.0), Quaternion::Identity()});
  PairRefinement pair(a, b);
  spend(pair, kUnlimitedTests);
  ASSERT_EQ(pair.overlapping().size(), 2U);
  const Contact contact = average_contact({0, 1}, pair, a, b, {});
  // Mean of ((±0.5, 0, 0) + (0, 1.5, 0)) / 2; two roundings.
  EXPECT_LT((contact.touch.point - Vector3(0.0, 0.75, 0.0)).norm(), 1e-15);
  EXPECT_LT((contact.touch.normal - Vector3::UnitY()).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(contact.touch.depth_m, 2.0 - std::sqrt(0.25 + 2.25));
}

TEST(ContactModel, OpposedNormalsFallBackOnTheChain) {
  // A ball exactly between two balls: the two normals cancel.
  const VolumeTree sphere = single_node_tree(Sphere{Vector3::Zero(), 1.0});
  const VolumeTree twins = two_levels({{0.5, 0.0, 0.0}, {-0.5, 0.0, 0.0}}, 1.0, 2.0);
  PlacedTree a(sphere);
  PlacedTree b(twins);
  PairRefinement pair(a, b);
  spend(pair, kUnlimitedTests);
  const auto normal = [&](const NormalFallbacks& fallbacks) {
    return average_contact({0, 1}, pair, a, b, fallbacks).touch.normal;
  };
  EXPECT_EQ(normal({Vector3(0.0, 0.0, 4.0), Vector3(0.0, 2.0, 0.0)}), Vector3::UnitZ());
  EXPECT_EQ(normal({Vector3::Zero(), Vector3(0.0, 2.0, 0.0)}), Vector3::UnitY());
  EXPECT_EQ(normal({Vector3::Zero(), Vector3::Zero()}), Vector3::UnitX());
}

TEST(ContactModel, NormalIsUnitAndThePointLiesWithinBothRoots) {
  RandomStream random(kSeed, "contacts");
  for (int trial = 0; trial < 300; ++trial) {
    TwoTrees trees(random);
    const PairRefinement pair = refined_to_the_end(trees);
    if (pair.overlapping().empty()) {
      continue;
    }
    const Contact contact = average_contact({0, 1}, pair, trees.a, trees.b, {});
    EXPECT_NEAR(contact.touch.normal.norm(), 1.0, 1e-15);
    for (PlacedTree* tree : {&trees.a, &trees.b}) {
      const Sphere& root = tree->world_sphere(0);
      EXPECT_LE((contact.touch.point - root.centre).norm(), root.radius_m + 1e-12);
    }
  }
}

}  // namespace impetus::collision_test
