// The order of work within a list, and that it decides when, never what.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/collision/budgeted_refinement.hpp"
#include "engine/collision/entry/node_gap.hpp"
#include "tests/engine/crowds.hpp"
#include "tests/engine/once.hpp"

namespace impetus::traversal_test {

constexpr std::uint64_t kSeed = 511;

/// Random pairs of trees of every kind, some of them apart, and of trees and walls.
struct RandomPairs {
  explicit RandomPairs(std::uint64_t seed) {
    RandomStream random(seed, "pairs of trees");
    static const std::vector<BodyModel> kinds = bodies_of_every_tree_kind();
    for (int i = 0; i < 12; ++i) {
      placed.emplace_back(*kinds[random.below(kinds.size())].tree);
      placed.back().move_to({random_in_cube(random, 0.08), random_turn(random)});
    }
    for (std::size_t i = 0; i + 1 < placed.size(); ++i) {
      const int list = i < 6 ? 0 : 1;
      pairs.push_back({{0, 1}, list, PairRefinement(placed[i], placed[i + 1])});
      pairs.back().eye_distance_m = uniform_in(random, 0.5, 4.0);
    }
    pairs.push_back({{0, kEnclosure}, 1, PairRefinement(placed[0], walls)});
    pairs.back().walls = kWallCount;
  }
  RandomPairs(const RandomPairs&) = delete;
  RandomPairs& operator=(const RandomPairs&) = delete;

  Enclosure walls{ClosedCube{0.1}};
  std::vector<PlacedTree> placed;
  std::vector<RefinedPair> pairs;
};

const std::vector<PriorityList> kTwoLists{{0.7}, {0.3}};

void expect_same_contacts(const RandomPairs& x, const RandomPairs& y) {
  for (std::size_t i = 0; i < x.pairs.size(); ++i) {
    EXPECT_EQ(x.pairs[i].refinement.overlapping(), y.pairs[i].refinement.overlapping());
    EXPECT_EQ(x.pairs[i].refinement.level(), y.pairs[i].refinement.level());
    EXPECT_EQ(x.pairs[i].refinement.stop_reason(), y.pairs[i].refinement.stop_reason());
  }
}

TEST(Traversal, WithUnlimitedWorkEveryOrderEndsInTheSameContacts) {
  std::size_t nodes = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomPairs alone(seed);
    for (RefinedPair& pair : alone.pairs) {
      while (!pair.refinement.resolved()) {
        pair.refinement.refine_one_block();
      }
      nodes += pair.refinement.overlapping().size();
    }
    for (const std::string_view traversal : traversal_names()) {
      RandomPairs many(seed);
      FixedWork all(kUnlimitedTests);
      static_cast<void>(
          refine_by_lists(many.pairs, kTwoLists, all, {make_traversal(traversal), kAllPhases, {}}));
      expect_same_contacts(many, alone);
    }
  }
  EXPECT_GT(nodes, 1'000U);
}

TEST(Traversal, InterruptedAndResumedEqualsWhole) {
  RandomStream random(kSeed, "slices");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const std::string_view traversal : traversal_names()) {
      const RefinementSettings settings{make_traversal(traversal), kAllPhases, {}};
      RandomPairs whole(seed);
      FixedWork all(kUnlimitedTests);
      static_cast<void>(refine_by_lists(whole.pairs, kTwoLists, all, settings));
      RandomPairs sliced(seed);
      int interruptions = 0;
      for (std::int64_t budget = 0;; ++interruptions) {
        FixedWork meter(budget);
        static_cast<void>(refine_by_lists(sliced.pairs, kTwoLists, meter, settings));
        const bool done =
            std::all_of(sliced.pairs.begin(), sliced.pairs.end(),
                        [](const RefinedPair& pair) { return pair.refinement.resolved(); });
        if (done) {
          break;
        }
        budget += static_cast<std::int64_t>(random.below(500));
      }
      EXPECT_GT(interruptions, 3);
      expect_same_contacts(sliced, whole);
    }
  }
}

TEST(Traversal, GrantsInSlicesDoTheWorkOfOneGrant) {
  RandomStream random(kSeed, "grants");
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const std::string_view traversal : traversal_names()) {
      const RefinementSettings settings{make_traversal(traversal), kAllPhases, {}};
      RandomPairs live(seed);
      RefusingWork slices(random, 1 + random.below(200));
      const WorkDone shown = refine_by_lists(live.pairs, kTwoLists, slices, settings);
      RandomPairs replay(seed);
      WorkGrants granted = shown.grants;
      granted.of(WorkPhase::kRefinement) = shown.granted;
      FixedWork total(granted);
      const WorkDone again = refine_by_lists(replay.pairs, kTwoLists, total, settings);
      expect_same_contacts(live, replay);
      EXPECT_EQ(again.spent, shown.spent);
      EXPECT_EQ(again.by_list, shown.by_list);
      EXPECT_EQ(again.peak, shown.peak);
    }
  }
}

const VolumeTree& l_block_tree() {
  static const VolumeTree tree = octree(small_l_block(), 3);
  return tree;
}

/// The level of every pair of a list of equal pairs after `budget` units.
std::vector<int> levels_after(std::string_view traversal, std::int64_t budget) {
  const VolumeTree& tree = l_block_tree();
  PlacedTree a(tree);
  PlacedTree b(tree);
  b.move_to({Vector3(0.03, 0.01, 0.02), Quaternion::Identity()});
  std::vector<RefinedPair> pairs;
  for (int i = 0; i < 8; ++i) {
    pairs.push_back({{0, 1}, 0, PairRefinement(a, b)});
  }
  FixedWork meter(budget);
  static_cast<void>(refine_by_lists(pairs, {{}}, meter, {make_traversal(traversal), {}, {}}));
  std::vector<int> levels;
  for (const RefinedPair& pair : pairs) {
    levels.push_back(pair.refinement.level());
  }
  return levels;
}

TEST(Traversal, BreadthFirstBringsAllPairsToALevelBeforeAnyGoesOn) {
  int uneven = 0;
  for (std::int64_t budget = 8; budget < 4'000; budget = budget * 5 / 4 + 1) {
    const std::vector<int> levels = levels_after("breadth-first", budget);
    EXPECT_TRUE(std::is_sorted(levels.rbegin(), levels.rend())) << "ties by priority";
    EXPECT_LE(levels.front() - levels.back(), 1) << budget;
    uneven += levels.front() != levels.back() ? 1 : 0;
  }
  EXPECT_GT(uneven, 2);
}

TEST(Traversal, DepthFirstTakesOnePairAfterTheOther) {
  const VolumeTree& tree = l_block_tree();
  int begun = 0;
  for (std::int64_t budget = 8; budget < 4'000; budget = budget * 5 / 4 + 1) {
    PlacedTree a(tree);
    PlacedTree b(tree);
    b.move_to({Vector3(0.03, 0.01, 0.02), Quaternion::Identity()});
    std::int64_t left = budget - 8;  // the roots
    std::vector<int> expected;
    for (int i = 0; i < 8; ++i) {
      PairRefinement pair(a, b);
      while (!pair.resolved() && pair.next_block() <= left) {
        left -= pair.next_block();
        pair.refine_one_block();
      }
      expected.push_back(pair.level());
    }
    EXPECT_EQ(levels_after("depth-first", budget), expected) << budget;
    begun += expected.front() > 0 && expected.back() == 0 ? 1 : 0;
  }
  EXPECT_GT(begun, 2);
}

/// Two spheres of radius 0.1 that halve at the next level, `apart_m` between their centres, with
/// fit errors and an occupancy that a builder would have stated.
VolumeTree halving_tree(float error_m, float occupancy) {
  const NodeSurface coarse{occupancy, kNoGroup, Eigen::Vector3f::Zero(), error_m};
  const NodeSurface fine{occupancy, kNoGroup, Eigen::Vector3f::Zero(), 0.5F * error_m};
  return {{{Sphere{{0, 0, 0}, 0.1}, 1, 2, coarse},
           {Sphere{{0.0, 0.04, 0}, 0.06}, 0, 0, fine},
           {Sphere{{0.0, -0.04, 0}, 0.06}, 0, 0, fine}},
          {0, 1}};
}

double urgency_of(const VolumeTree& tree, double apart_m, double eye_distance_m) {
  PlacedTree a(tree);
  PlacedTree b(tree);
  b.move_to({Vector3(apart_m, 0.0, 0.0), Quaternion::Identity()});
  RefinedPair pair{{0, 1}, 0, PairRefinement(a, b)};
  pair.eye_distance_m = eye_distance_m;
  return urgency(pair, *make_traversal("best-first"), PhaseCosts({1, 1, 0, 0}, {}));
}

TEST(Traversal, BestFirstExpectsVisibleGapTimesProbabilityPerWork) {
  // 2 (0.02 − 0.01) m seen from 1 m; κ = (0.2 − 0.1) / 0.2, ρ² = ¼; four tests.
  const double gap_deg = 2.0 * std::atan(0.01) * 180.0 / std::numbers::pi;
  // The errors are stored as floats.
  EXPECT_NEAR(urgency_of(halving_tree(0.02F, 0.5F), 0.1, 1.0), gap_deg * 0.5 * 0.25 / 4.0, 1e-8);
  const double base = urgency_of(halving_tree(0.02F, 0.5F), 0.1, 1.0);
  EXPECT_GT(urgency_of(halving_tree(0.03F, 0.5F), 0.1, 1.0), base) << "a larger gap goes";
  EXPECT_GT(urgency_of(halving_tree(0.02F, 0.9F), 0.1, 1.0), base) << "more solid";
  EXPECT_GT(urgency_of(halving_tree(0.02F, 0.5F), 0.05, 1.0), base) << "deeper";
  EXPECT_GT(urgency_of(halving_tree(0.02F, 0.5F), 0.1, 0.5), base) << "nearer";
}

TEST(Traversal, BestFirstRemovesMoreVisibleGapThanDepthFirst) {
  // Near the eye and far from it in turn; the priority is the order given.
  const VolumeTree& tree = l_block_tree();
  const auto gap_left = [&](std::string_view traversal, std::int64_t budget) {
    std::vector<PlacedTree> placed(9, PlacedTree(tree));
    std::vector<RefinedPair> pairs;
    for (std::size_t i = 1; i < placed.size(); ++i) {
      placed[i].move_to(
          {Vector3(0.01 * static_cast<double>(i), 0.01, 0.02), Quaternion::Identity()});
      pairs.push_back({{0, static_cast<std::int32_t>(i)}, 0, PairRefinement(placed[0], placed[i])});
      pairs.back().eye_distance_m = i % 2 == 0 ? 0.5 : 5.0;
    }
    FixedWork meter(budget);
    static_cast<void>(refine_by_lists(pairs, {{}}, meter, {make_traversal(traversal), {}, {}}));
    double sum = 0.0;
    for (const RefinedPair& pair : pairs) {
      const bool apart = pair.refinement.overlapping().empty();
      sum +=
          apart ? 0.0 : pair.refinement.fit_error_m(pair.refinement.level()) / pair.eye_distance_m;
    }
    return sum;
  };
  for (const std::int64_t budget : {400, 1'000, 3'000}) {
    EXPECT_LT(gap_left("best-first", budget), gap_left("depth-first", budget));
  }
}

double visible_urgency_of(const VolumeTree& tree, double apart_m, double eye_distance_m,
                          double acuity) {
  PlacedTree a(tree);
  PlacedTree b(tree);
  b.move_to({Vector3(apart_m, 0.0, 0.0), Quaternion::Identity()});
  RefinedPair pair{{0, 1}, 0, PairRefinement(a, b)};
  pair.eye_distance_m = eye_distance_m;
  pair.acuity = acuity;
  return urgency(pair, *make_traversal("visible-first"), PhaseCosts({1, 1, 0, 0}, {}));
}

TEST(Traversal, VisibleFirstExpectsTheGapThatOpensTimesAcuityPerWork) {
  // Errors fall by D = 2 · 0.01 m, the roots overlap by δ = 0.2 − 0.195 m: (D − δ)² / 2D, seen from
  // 1 m at half the acuity, for four tests.
  const double gap_m = 0.015 * 0.015 / (2.0 * 0.02);
  const double gap_deg = 2.0 * std::atan(0.5 * gap_m) * 180.0 / std::numbers::pi;
  const VolumeTree tree = halving_tree(0.02F, 0.5F);
  const double base = visible_urgency_of(tree, 0.195, 1.0, 0.5);
  EXPECT_NEAR(base, gap_deg * 0.5 / 4.0, 1e-8);  // the errors are stored as floats
  EXPECT_GT(visible_urgency_of(halving_tree(0.03F, 0.5F), 0.195, 1.0, 0.5), base) << "looser";
  EXPECT_GT(visible_urgency_of(tree, 0.198, 1.0, 0.5), base) << "less deep";
  EXPECT_GT(visible_urgency_of(tree, 0.195, 0.5, 0.5), base) << "nearer";
  EXPECT_GT(visible_urgency_of(tree, 0.195, 1.0, 0.6), base) << "more central";
  EXPECT_EQ(visible_urgency_of(tree, 0.15, 1.0, 0.5), 0.0) << "too deep to part";
}

TEST(Traversal, VisibleFirstRemovesWhatWouldBeNoticedWhereThatIsKnown) {
  const auto urgency_at = [&](const Noticing& noticing, double threshold_arcmin) {
    const VolumeTree tree = halving_tree(0.02F, 0.5F);
    PlacedTree still(tree);
    PlacedTree moved(tree);
    moved.move_to({Vector3(0.195, 0.0, 0.0), Quaternion::Identity()});
    RefinedPair pair{{0, 1}, 0, PairRefinement(still, moved)};
    pair.noticing = &noticing;
    pair.noticed_arcmin = threshold_arcmin;
    return urgency(pair, *make_traversal("visible-first"), PhaseCosts({1, 1, 0, 0}, {}));
  };
  // The gap expected to open, as above, from 1 m: noticed half of the time at just that angle.
  const double gap_m = 0.015 * 0.015 / (2.0 * 0.02);
  const double gap_arcmin = 60.0 * 2.0 * std::atan(0.5 * gap_m) * 180.0 / std::numbers::pi;
  const Noticing noticing{10.0, 0.2, 0.2};
  EXPECT_NEAR(urgency_at(noticing, gap_arcmin), 0.5 * 0.8 / 4.0, 1e-6);
  EXPECT_NEAR(urgency_at(noticing, 0.01 * gap_arcmin), 0.8 / 4.0, 1e-6) << "surely";
  EXPECT_NEAR(urgency_at(noticing, 100.0 * gap_arcmin), 0.0, 1e-6) << "never";
}

TEST(Traversal, VisibleFirstLooksBeyondALevelThatGainsNothing) {
  // The errors stay for a level and fall at the next.
  const NodeSurface loose{1.0F, kNoGroup, Eigen::Vector3f::Zero(), 0.02F};
  const NodeSurface close{1.0F, kNoGroup, Eigen::Vector3f::Zero(), 0.0F};
  const VolumeTree tree({{Sphere{{0, 0, 0}, 0.1}, 1, 1, loose},
                         {Sphere{{0, 0, 0}, 0.1}, 2, 1, loose},
                         {Sphere{{0, 0, 0}, 0.08}, 0, 0, close}},
                        {0, 1, 2});
  EXPECT_GT(visible_urgency_of(tree, 0.195, 1.0, 1.0), 0.0);
}

TEST(Traversal, TheDeepestOverlapIsNeverLessThanThatOfTheDeepestNodes) {
  int overlapping = 0;
  double sum_m = 0.0;
  double exact_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomPairs random(seed);
    for (std::size_t i = 0; i + 1 < random.placed.size(); ++i) {
      PairRefinement& pair = random.pairs[i].refinement;
      while (!pair.resolved() && pair.level() < 2) {
        pair.refine_one_block();
      }
      double deepest_m = 0.0;
      for (const NodePair& nodes : pair.overlapping()) {
        const NodeGap gap = gap_of_nodes(random.placed[i].world_volume(nodes.a),
                                         random.placed[i + 1].world_volume(nodes.b));
        deepest_m = std::max(deepest_m, -gap.gap_m);
      }
      if (pair.overlapping().empty()) {
        continue;
      }
      ++overlapping;
      EXPECT_GE(pair.deepest_overlap_m(), deepest_m - 1e-12) << seed;
      sum_m += pair.deepest_overlap_m();
      exact_m += deepest_m;
    }
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_LT(sum_m, 1.5 * exact_m) << "and no more than needed";
}

TEST(Traversal, TheDeepestReachBeyondAWallIsThatOfTheNodeFurthestOut) {
  int overlapping = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomPairs random(seed);
    PairRefinement& pair = random.pairs.back().refinement;
    while (!pair.resolved() && pair.level() < 2) {
      pair.refine_one_block();
    }
    double furthest_m = 0.0;
    for (const NodePair& nodes : pair.overlapping()) {
      for (int wall = 0; wall < kWallCount; ++wall) {
        furthest_m = std::max(furthest_m,
                              touch_of_wall(random.placed[0], nodes.a, random.walls, wall).depth_m);
      }
    }
    EXPECT_NEAR(pair.deepest_overlap_m(), furthest_m, 1e-12) << seed;
    overlapping += furthest_m > 0.0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, 10);
}

TEST(Traversal, WaitingPairsComeAsASortWouldHaveThem) {
  RandomStream random(kSeed, "queue");
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::pair<double, std::size_t>> expected;
    WaitingPairs waiting;
    for (std::size_t index = 0; index < 1 + random.below(50); ++index) {
      const auto urgency = static_cast<double>(random.below(5));
      expected.emplace_back(-urgency, index);
      waiting.add(index, urgency);
    }
    std::sort(expected.begin(), expected.end());
    for (const auto& [negative, index] : expected) {
      ASSERT_EQ(waiting.next(), index);
      waiting.remove_next();
    }
    ASSERT_TRUE(waiting.empty());
  }
}

TEST(Traversal, EveryOrderReplaysAndAnUnlimitedBudgetEndsAllInOneState) {
  WorldSettings settings;
  World plain = random_tree_world(9, 5, settings);
  for (const char* traversal : {"breadth-first", "best-first", "visible-first"}) {
    World depth_first = plain;
    settings.schedule.traversal = make_traversal(traversal);
    World other = random_tree_world(9, 5, settings);
    for (int step = 0; step < 300; ++step) {
      ASSERT_EQ(step_whole(depth_first).state.hash, step_whole(other).state.hash);
    }
  }
}

}  // namespace impetus::traversal_test
