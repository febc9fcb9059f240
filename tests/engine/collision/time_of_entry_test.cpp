// What tells fast pairs from slow ones, and when they first touch: half-thicknesses, the cap on
// levels, ways and their entries.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/depth_on_the_way.hpp"
#include "tests/engine/one_of_each_kind.hpp"
#include "tests/engine/shots.hpp"

namespace impetus::time_of_entry_test {

constexpr std::uint64_t kSeed = 63;

// h(level): the least half-width of the nodes that stand at the level.
TEST(HalfThickness, IsTheLeastOfTheNodesThatStandAtALevel) {
  RandomStream random(kSeed, "half thickness");
  for (int trial = 0; trial < 100; ++trial) {
    const VolumeTree tree = random_tree(random, 5);
    for (int level = 0; level < 7; ++level) {
      double least = 1e9;
      for (const std::int32_t node : tree.standing_at(level)) {
        least = std::min(least, std::get<Sphere>(tree.volume(node)).radius_m);
      }
      ASSERT_EQ(tree.least_half_thickness_m(level), least);
    }
  }
}

TEST(HalfThickness, OfEachKindIsHalfItsLeastWidth) {
  RandomStream random(kSeed, "widths");
  for (int trial = 0; trial < 50; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, Vector3::Zero(), 1.0)) {
      const CoredVolume whole = cored(volume);
      double least = 1e9;
      for (int i = 0; i < 400; ++i) {
        const Vector3 direction = random_direction(random);
        least = std::min(least, reach_along(whole.core, direction) + whole.radius_m);
      }
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3 direction = whole.core.axes.col(axis);
        least = std::min(least, reach_along(whole.core, direction) + whole.radius_m);
      }
      ASSERT_NEAR(least_half_width_m(volume), least, 1e-14);
    }
  }
}

TEST(RecursionCap, StaysAtLevelsWhoseNodesAreThickerThanTheWay) {
  const BodyModel target = plate("octree");
  const BodyModel model = plate("octree");
  const VolumeTree& tree = *target.tree;
  ASSERT_GE(tree.level_count(), 4);
  for (int level = 0; level + 1 < tree.level_count(); ++level) {
    // Just more than the next level's nodes allow, and no more than this one's.
    const double way_m = 1.001 * tree.least_half_thickness_m(level + 1);
    EXPECT_EQ(capped_level(tree, tree, way_m, kUnlimitedLevel), level);
    EXPECT_EQ(capped_level(tree, tree, way_m, 0), 0);
    World world({target, model},
                {moving(target, Vector3::Zero(), Vector3(7.0, 0.0, 0.0)),
                 moving(model, {0.001, 0.0, 0.0}, Vector3(7.0 + way_m, 0.0, 0.0))},
                handled(Tunnelling::kCapped));
    const StepReport report = step_whole(world, 1.0);
    ASSERT_EQ(report.collisions.size(), 1U);
    EXPECT_EQ(report.collisions[0].level, level);
    EXPECT_EQ(report.collisions[0].stop, StopReason::kCapped);
  }
  const double slow_m = 0.999 * tree.least_half_thickness_m(99);
  EXPECT_EQ(capped_level(tree, tree, slow_m, kUnlimitedLevel), kUnlimitedLevel);
  EXPECT_EQ(capped_level(tree, tree, 1e9, kUnlimitedLevel), 0) << "the coarsest is never refused";
}

TEST(RecursionCap, BodiesThatMoveTogetherAndSpinnersCountByTheirRelativeWay) {
  const BodyModel target = plate("octree");
  const auto stop_of = [&](const Vector3& velocity_m_s, double spin, int greatest_level) {
    BodyState spinning = moving(target, {0.001, 0.0, 0.0}, velocity_m_s);
    spinning.angular_momentum =
        angular_momentum_at(target, spinning.pose.orientation, {0.0, 0.0, spin});
    WorldSettings settings = handled(Tunnelling::kCapped);
    settings.schedule.lists[0].greatest_level = greatest_level;
    World world({target, target}, {moving(target, Vector3::Zero(), {50.0, 0.0, 0.0}), spinning},
                settings);
    return step_whole(world, 1.0).collisions.at(0).stop;
  };
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 0.0, kUnlimitedLevel), StopReason::kFinest);
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 1.0, kUnlimitedLevel), StopReason::kCapped);
  EXPECT_EQ(stop_of({50.0, 0.0, 0.0}, 1.0, 0), StopReason::kGreatestLevel) << "the list's own";
}

BodyPath any_path(RandomStream& random) {
  BodyPath path{{random_in_cube(random, 1.0), random_turn(random)},
                {random_in_cube(random, 1.0), random_turn(random)}};
  path.begin = random.below(2) == 0 ? 0.0 : 0.5 * random.uniform();
  path.stop = random.below(2) == 0 ? 1.0 : path.begin + (1.0 - path.begin) * random.uniform();
  return path;
}

TEST(BodyPath, NoPointMovesFasterThanItsBound) {
  RandomStream random(kSeed, "paths");
  for (int trial = 0; trial < 200; ++trial) {
    const BodyPath a = any_path(random);
    const BodyPath b = any_path(random);
    const Vector3 on_a = random_in_cube(random, 0.5);
    const Vector3 on_b = random_in_cube(random, 0.5);
    const auto stretches = stretches_of(a, b);
    const auto apart = [&](double time) {
      return Vector3(pose_at(a, time).transform(on_a) - pose_at(b, time).transform(on_b));
    };
    constexpr int kMoments = 500;
    for (int moment = 0; moment < kMoments; ++moment) {
      const double from = static_cast<double>(moment) / kMoments;
      const double to = static_cast<double>(moment + 1) / kMoments;
      const double bound_m = way_from(from, stretches, on_a.norm(), on_b.norm()) -
                             way_from(to, stretches, on_a.norm(), on_b.norm());
      ASSERT_LE((apart(to) - apart(from)).norm(), bound_m + 1e-12) << "seed " << kSeed;
    }
    EXPECT_EQ(pose_at(a, 1.0).position, a.end.position);
    EXPECT_EQ(pose_at(a, 0.0).position, a.start.position);
  }
}

// Where a point is a little later: on along its velocity, but for half of the bend times the time
// squared; and no bound of a bend is more than it needs to be by far.
TEST(BodyPath, APointStraysFromItsWayByNoMoreThanTheBend) {
  RandomStream random(kSeed, "bends");
  double most = 0.0;
  for (int trial = 0; trial < 2'000; ++trial) {
    BodyPath path = any_path(random);
    path.end.position = path.start.position;
    const Vector3 on_body = random_direction(random);
    const RelativeStretch stretch = stretches_of(path, BodyPath{})[path.begin > 0.0 ? 1 : 0];
    ASSERT_GT(stretch.bend_a, 0.0);
    const double from = path.begin + (path.stop - path.begin) * random.uniform();
    const double to = from + (path.stop - from) * random.uniform();
    const Vector3 here = pose_at(path, from).transform(on_body);
    const Vector3 there = pose_at(path, to).transform(on_body);
    const Vector3 arm = here - path.start.position;
    const Vector3 foreseen = here + (to - from) * turning_at(path, from).cross(arm);
    const double bound_m = 0.5 * stretch.bend_a * (to - from) * (to - from);
    ASSERT_LE((there - foreseen).norm(), bound_m + 1e-12) << "seed " << kSeed << ", " << trial;
    most = std::max(most, bound_m > 1e-6 ? (there - foreseen).norm() / bound_m : 0.0);
  }
  EXPECT_GT(most, 0.7);
}

/// Whether the pair stops where it first touches by no more than a hair, by the depths at many
/// moments; tells whether it stops at all.
bool stops_at_entry(const PairOnTheWay& pair, int moments) {
  const double slow_m = slow_way_m(pair.a.tree(), pair.b.tree(), pair.greatest_level);
  const Entry entry = time_of_entry(pair);
  EXPECT_LT(entry.tests, pair.most_tests);
  if (entry.time) {
    EXPECT_GE(depth_at(pair, *entry.time), 0.0) << "they touch where they stop";
  }
  const auto stretches = stretches_of(pair.path_a, pair.path_b);
  for (int moment = 0; moment <= moments; ++moment) {
    const double time = static_cast<double>(moment) / moments;
    const double left_m = way_from(time, stretches, pair.a.tree().bounding_radius_m(),
                                   pair.b.tree().bounding_radius_m());
    if (entry.time ? time <= *entry.time : left_m > 0.5 * slow_m) {
      EXPECT_LE(depth_at(pair, time), 0.125 * slow_m + 1e-12) << "time " << time;
    }
  }
  return entry.time.has_value();
}

class EntryBy : public testing::TestWithParam<EntryRules> {};

TEST_P(EntryBy, IsTheFirstAtWhichTheRefinementFindsMoreThanAHair) {
  RandomStream random(kSeed, "entries");
  int entries = 0;
  int misses = 0;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const VolumeTree tree_a = random_tree(random, 3);
    const VolumeTree tree_b = random_tree(random, 3);
    PlacedTree a(tree_a);
    PlacedTree b(tree_b);
    const Vector3 from = 4.0 * random_direction(random);
    const Vector3 to = random_in_cube(random, 3.0) - uniform_in(random, 0.0, 1.0) * from;
    const BodyPath path_a{{from, random_turn(random)}, {to, random_turn(random)}};
    const BodyPath path_b{{Vector3::Zero(), random_turn(random)},
                          {random_in_cube(random, 0.3), random_turn(random)}};
    PairOnTheWay pair{a, b, path_a, path_b, static_cast<int>(random.below(4))};
    pair.rules = GetParam();
    ++(stops_at_entry(pair, 500) ? entries : misses);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(entries, 30);
  EXPECT_GT(misses, 30);
}

std::string name_of(const testing::TestParamInfo<EntryRules>& rules) {
  constexpr std::array kNames{"DirectedSpeeds", "NearestFirst", "WaysOfNodes"};
  return kNames.at(static_cast<std::size_t>(rules.param));
}

INSTANTIATE_TEST_SUITE_P(Rules, EntryBy,
                         testing::Values(EntryRules::kDirected, EntryRules::kNearestFirst,
                                         EntryRules::kNodeWays),
                         name_of);

class EntryOfKind : public testing::TestWithParam<const char*> {};

// Apart at first, and turning by up to half a radian on their way. Of kinds whose nodes lie within
// their parents: where they do not, nodes are deeper than a hair when their parents first touch.
TEST_P(EntryOfKind, IsTheFirstAtWhichTheRefinementFindsMoreThanAHair) {
  RandomStream random(kSeed, "kinds");
  const VolumeTree tree = build_tree(small_l_block(), {tree_kind(GetParam()), 2, 8});
  PlacedTree a(tree);
  PlacedTree b(tree);
  const double size_m = tree.bounding_radius_m();
  int entries = 0;
  int misses = 0;
  for (int trial = 0; trial < 80; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const auto turned = [&](const Quaternion& from) {
      const Vector3 turn = random_in_cube(random, 0.3);
      return Quaternion(Quaternion(1.0, turn.x(), turn.y(), turn.z()).normalized() * from);
    };
    BodyPath path_a{{2.1 * size_m * random_direction(random), random_turn(random)}, {}};
    path_a.end = {
        path_a.start.position + random_in_cube(random, size_m) - 0.7 * path_a.start.position,
        turned(path_a.start.orientation)};
    BodyPath path_b{{Vector3::Zero(), random_turn(random)}, {}};
    path_b.end.orientation = turned(path_b.start.orientation);
    const PairOnTheWay pair{a, b, path_a, path_b, kUnlimitedLevel, kUnlimitedTests};
    ++(stops_at_entry(pair, 200) ? entries : misses);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(entries, 5);
  EXPECT_GT(misses, 5);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EntryOfKind,
                         testing::Values("octree", "box", "swept", "heterogeneous"),
                         [](const auto& kind) { return std::string(kind.param); });

}  // namespace impetus::time_of_entry_test
