// The pairs that a world lends are those among which its step shared its work, as it did.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "tests/engine/crowds.hpp"

namespace impetus::lent_pairs_test {

/// Three lists in which the crowd's pairs spread.
Schedule three_lists(std::string_view metric, double first, double second) {
  Schedule schedule;
  schedule.metric = make_metric(metric);
  schedule.lists = {{}, {}, {}};
  schedule.limits = {first, second};
  return schedule;
}

/// The pair that a collision is of.
const ScheduledPair* pair_of(const CollisionReport& collision,
                             const std::vector<ScheduledPair>& pairs) {
  const BodyPair bodies{collision.bodies.a,
                        is_wall(collision.bodies.b) ? kEnclosure : collision.bodies.b};
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&bodies](const ScheduledPair& pair) {
    return pair.pair == bodies;
  });
  return found == pairs.end() ? nullptr : &*found;
}

TEST(LentPairs, HoldEveryCollisionInItsOwnListWhateverPersists) {
  for (const std::int64_t persistence_steps : {0, 12}) {
    for (Schedule schedule :
         {three_lists("distance", 9.8, 10.1), three_lists("eccentricity", 1.5, 2.5),
          three_lists("velocity", 1.0, 2.0), three_lists("size", 1.74, 1.70)}) {
      schedule.persistence_steps = persistence_steps;
      World world = enclosed_l_blocks(27, /*depth=*/2, schedule);
      world.watch_pairs(true);
      std::set<int> lists;
      for (int step = 0; step < 240; ++step) {
        const StepReport report = step_whole(world);
        // One test of the roots for each pair is the floor of lists without a least level.
        ASSERT_EQ(static_cast<std::int64_t>(world.pairs().size()), report.work_floor);
        for (const CollisionReport& collision : report.collisions) {
          const ScheduledPair* pair = pair_of(collision, world.pairs());
          ASSERT_NE(pair, nullptr);
          ASSERT_EQ(pair->list, collision.list);
          lists.insert(collision.list);
        }
      }
      EXPECT_GE(lists.size(), 2U) << "thresholds that part nothing: " << schedule.limits[0];
    }
  }
}

TEST(LentPairs, ComeByListAndByFallingPriorityWithinEach) {
  // A metric that a pair's bodies decide, so that the order can be told from outside.
  class ByBodies final : public PriorityMetric {
   public:
    ByBodies() : PriorityMetric(Urgent::kLarge) {}
    [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                                 const Fixation& /*fixation*/) const override {
      return 7 * bounds.pair.a % 5 + (is_wall(bounds.pair.b) ? 0.5 : bounds.pair.b % 3);
    }
  };
  Schedule schedule = three_lists("distance", 4.0, 2.0);
  schedule.metric = std::make_shared<ByBodies>();
  for (const int least_level : {0, 2}) {  // at 2 no pair waits for work: the step needs no order
    for (PriorityList& list : schedule.lists) {
      list.least_level = least_level;
    }
    World world = enclosed_l_blocks(27, /*depth=*/2, schedule);
    world.watch_pairs(true);
    std::size_t most = 0;
    for (int step = 0; step < 60; ++step) {
      step_whole(world);
      double before = 10.0;
      for (const ScheduledPair& pair : world.pairs()) {
        const double measured = ByBodies().measure({pair.pair, {}, {}}, {}, {});
        EXPECT_LE(measured, before);
        EXPECT_EQ(pair.list, measured >= 4.0 ? 0 : measured >= 2.0 ? 1 : 2);
        before = measured;
      }
      most = std::max(most, world.pairs().size());
    }
    EXPECT_GT(most, 10U);
  }
}

TEST(LentPairs, ToWatchThemChangesNoBitAndWithoutItThereAreNone) {
  RandomStream random(27, "settings");
  for (int trial = 0; trial < 20; ++trial) {
    World plain =
        squeezed_crowd(random, bodies_of_every_tree_kind(), 12, 0.16, random_settings(random));
    World watched = plain;
    watched.watch_pairs(true);
    for (int step = 0; step < 40; ++step) {
      FixedWork meter(300);
      const StepReport expected = plain.step(looking_ahead(), meter);
      const StepReport report = watched.step(looking_ahead(), meter);
      ASSERT_EQ(report.state.hash, expected.state.hash);
      ASSERT_EQ(report.list_work, expected.list_work);
      ASSERT_TRUE(plain.pairs().empty());
      ASSERT_FALSE(watched.pairs().empty());
    }
    const World copy = watched;
    EXPECT_TRUE(copy.pairs().empty()) << "of a step that it has not made";
  }
}

}  // namespace impetus::lent_pairs_test
