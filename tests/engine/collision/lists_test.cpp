// Priority lists: who falls where, shares, least and greatest levels, and the replay of both.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/collision/budgeted_refinement.hpp"
#include "engine/scheduling/metrics.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/scheduled_pairs.hpp"

namespace impetus::lists_test {

constexpr ScreenGeometry kScreen{0.5, 0.3, 1600, 900, 0.5};

PairBounds small_pair_at(const Vector3& place) { return {{0, 1}, {place, 0.01}, {place, 0.01}}; }

int list_of(const PairBounds& pair, const Schedule& schedule,
            const std::optional<GazeRegion>& region = {}) {
  return scheduled({pair}, schedule, viewer_at(kScreen, 0.0), {}, region).front().list;
}

Schedule lists_by(const char* metric, std::vector<double> thresholds) {
  Schedule schedule;
  schedule.metric = make_metric(metric);
  schedule.lists.resize(thresholds.size() + 1);
  schedule.limits = std::move(thresholds);
  return schedule;
}

Schedule by_region(int bad_level = kUnlimitedLevel) {
  Schedule schedule;
  schedule.rule = make_list_rule("region");
  schedule.lists = {{0.5, 0, kUnlimitedLevel}, {0.5, 0, bad_level}};
  return schedule;
}

TEST(Lists, ThresholdsOfASmallFirstMetricRise) {
  const Schedule schedule = lists_by("distance", {0.5, 1.0});
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, 0.1}), schedule), 0);
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, 0.0}), schedule), 0) << "meeting it is enough";
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, -0.1}), schedule), 1);
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, -9.0}), schedule), 2);
}

TEST(Lists, ThresholdsOfALargeFirstMetricFall) {
  // A radius of 0.01 m spans 2 asin(0.01 / d) degrees: 2.3 at 0.5 m, 0.76 at 1.5 m.
  const Schedule schedule = lists_by("size", {2.0, 1.0});
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, 0.0}), schedule), 0);
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, -0.3}), schedule), 1);
  EXPECT_EQ(list_of(small_pair_at({0.0, 0.0, -1.0}), schedule), 2);
}

TEST(Lists, InsideTheRegionIsListZeroAndItsBorderCounts) {
  // 5° about a point 0.1 m right of the centre, seen from 0.5 m.
  const GazeRegion region{{0.1, 0.0}, 5.0};
  const double centre_rad = std::atan2(0.1, 0.5);
  for (const double off_deg : {-6.0, -4.9, 0.0, 4.9, 5.1, 20.0}) {
    const double x = 0.5 * std::tan(centre_rad + off_deg * std::numbers::pi / 180.0);
    const int expected = std::fabs(off_deg) <= 5.0 ? 0 : 1;
    EXPECT_EQ(list_of(small_pair_at({x, 0.0, 0.0}), by_region(), region), expected) << off_deg;
    // Twice as far from the eye along the same ray: it projects alike.
    EXPECT_EQ(list_of(small_pair_at({2.0 * x, 0.0, -0.5}), by_region(), region), expected);
  }
  EXPECT_EQ(list_of(small_pair_at(Vector3::Zero()), by_region()), 1) << "no region: outside";
}

TEST(Lists, PairsComeByListThenByPriority) {
  const std::vector<PairBounds> pairs{
      {{0, 1}, {Vector3(0, 0, -3.0), 0.1}, {Vector3(0, 0, -3), 0.1}},
      {{0, 2}, {Vector3(0, 0, 0.0), 0.1}, {Vector3(0, 0, 0), 0.1}},
      {{0, 3}, {Vector3(0, 0, -2.0), 0.1}, {Vector3(0, 0, -2), 0.1}},
      {{0, 4}, {Vector3(0, 0, 0.2), 0.1}, {Vector3(0, 0, 0.2), 0.1}}};
  std::vector<std::int32_t> order;
  for (const ScheduledPair& pair :
       scheduled(pairs, lists_by("distance", {1.0}), viewer_at(kScreen, 0.0), {}, {})) {
    order.push_back(pair.pair.b);
    EXPECT_EQ(pair.list, pair.pair.b % 2 == 0 ? 0 : 1);
  }
  EXPECT_EQ(order, (std::vector<std::int32_t>{4, 2, 3, 1}));
}

TEST(Lists, ASchedulesProblemIsNamed) {
  const auto with_lists = [](std::vector<PriorityList> lists, std::vector<double> thresholds) {
    Schedule schedule;
    schedule.lists = std::move(lists);
    schedule.limits = std::move(thresholds);
    return problem_of(schedule);
  };
  EXPECT_EQ(problem_of(Schedule{}), "");
  EXPECT_EQ(problem_of(by_region()), "");
  EXPECT_EQ(problem_of(lists_by("distance", {1.0, 2.0})), "");
  EXPECT_EQ(problem_of(lists_by("size", {2.0, 1.0})), "");
  EXPECT_EQ(with_lists({}, {}), "schedule: expected 1 to 16 lists, got 0");
  EXPECT_EQ(with_lists(std::vector<PriorityList>(17), {}),
            "schedule: expected 1 to 16 lists, got 17");
  EXPECT_EQ(with_lists({{-1.0}}, {}), "schedule: expected a share of at least 0, got -1.000000");
  EXPECT_EQ(with_lists({{0.0}}, {}), "schedule: expected a list with a share above 0, got none");
  EXPECT_EQ(with_lists({{1.0, 3, 2}}, {}),
            "schedule: expected 0 <= least level <= greatest level, got 3 and 2");
  EXPECT_EQ(with_lists({{1.0}, {1.0}}, {}), "schedule: expected 1 thresholds, got 0");
  const std::string order = "schedule: expected finite thresholds from high priority to low, got ";
  EXPECT_EQ(problem_of(lists_by("distance", {2.0, 1.0})), order + "1.000000 as number 2");
  EXPECT_EQ(problem_of(lists_by("size", {1.0, 2.0})), order + "2.000000 as number 2");
  EXPECT_EQ(problem_of(lists_by("size", {std::nan("")})), order + "nan as number 1");
  Schedule three = by_region();
  three.lists.emplace_back();
  EXPECT_EQ(problem_of(three), "schedule: expected two lists for a region, got 3");
}

TEST(Lists, AWorldRefusesABadSchedule) {
  WorldSettings settings;
  settings.schedule.lists.clear();
  EXPECT_THROW(World({}, {}, settings), std::invalid_argument);
}

/// Many pairs of the same two overlapping trees, `per_list` in each list.
struct ManyPairs {
  ManyPairs(const std::vector<PriorityList>& lists, std::vector<int> per_list)
      : tree(octree(small_l_block(), 4)), a(tree), b(tree) {
    b.move_to({Vector3(0.03, 0.01, 0.02), Quaternion::Identity()});
    for (std::size_t list = 0; list < per_list.size(); ++list) {
      for (int i = 0; i < per_list[list]; ++i) {
        pairs.push_back(
            {{0, 1}, static_cast<int>(list), PairRefinement(a, b, lists[list].greatest_level)});
      }
    }
  }
  ManyPairs(const ManyPairs&) = delete;
  ManyPairs& operator=(const ManyPairs&) = delete;

  VolumeTree tree;
  PlacedTree a;
  PlacedTree b;
  std::vector<RefinedPair> pairs;
};

// Blocks have at most 8 × 8 tests, and a list may be one block ahead of its share.
constexpr double kLargestBlock = 64.0;

WorkDone refined(const std::vector<PriorityList>& lists, std::vector<int> per_list,
                 std::int64_t budget) {
  ManyPairs many(lists, std::move(per_list));
  FixedWork meter(budget);
  return refine_by_lists(many.pairs, lists, meter);
}

TEST(Lists, SharesAreKeptWhereverTheBudgetCutsThem) {
  const std::vector<PriorityList> lists{{0.5}, {0.3}, {0.2}};
  for (const std::int64_t budget : {100, 300, 1'000, 5'000, 20'000}) {
    const WorkDone work = refined(lists, {20, 20, 20}, budget);
    const auto beyond = static_cast<double>(work.spent - work.floor);
    ASSERT_GT(static_cast<double>(work.spent), static_cast<double>(budget) - kLargestBlock);
    ASSERT_EQ(std::accumulate(work.by_list.begin(), work.by_list.end(), std::int64_t{0}),
              work.spent - work.floor);
    for (std::size_t list = 0; list < 3; ++list) {
      EXPECT_NEAR(static_cast<double>(work.by_list[list]), lists[list].share * beyond,
                  2.0 * kLargestBlock)
          << "budget " << budget << ", list " << list;
    }
  }
}

TEST(Lists, UnusedWorkFlowsOnToTheNextListInOrder) {
  // List 1 has nothing to do: its half goes to list 2, not to list 0.
  const std::vector<PriorityList> lists{{0.25}, {0.5}, {0.25}};
  const WorkDone work = refined(lists, {20, 0, 20}, 10'000);
  const auto beyond = static_cast<double>(work.spent - work.floor);
  EXPECT_NEAR(static_cast<double>(work.by_list[0]), 0.25 * beyond, 2.0 * kLargestBlock);
  EXPECT_NEAR(static_cast<double>(work.by_list[2]), 0.75 * beyond, 2.0 * kLargestBlock);
  // The last one's goes to the first.
  const WorkDone wrapped = refined(lists, {20, 20, 0}, 10'000);
  EXPECT_NEAR(static_cast<double>(wrapped.by_list[0]), 0.5 * beyond, 2.0 * kLargestBlock);
}

TEST(Lists, OfEqualListsTheFirstBegins) {
  const std::vector<PriorityList> lists{{0.5}, {0.5}};
  ManyPairs many(lists, {5, 5});
  const std::int64_t one_block = many.pairs.front().refinement.next_block();
  FixedWork meter(10 + one_block);  // after the roots
  const WorkDone work = refine_by_lists(many.pairs, lists, meter);
  EXPECT_EQ(work.by_list[0], one_block);
  EXPECT_EQ(work.by_list[1], 0);
}

TEST(Lists, AListThatFinishesEarlyLeavesTheRestOfItsShare) {
  const std::vector<PriorityList> lists{{0.5}, {0.5}};
  const std::int64_t one_pair = refined(lists, {1, 0}, kUnlimitedTests).by_list[0];
  const WorkDone work = refined(lists, {1, 20}, 6 * one_pair);
  EXPECT_EQ(work.by_list[0], one_pair) << "done with";
  EXPECT_GT(static_cast<double>(work.by_list[1]),
            static_cast<double>(5 * one_pair - 21) - kLargestBlock);
}

TEST(Lists, AShareOfZeroGetsOnlyWhatOthersLeave) {
  const std::vector<PriorityList> lists{{0.0}, {1.0}};
  EXPECT_EQ(refined(lists, {5, 20}, 2'000).by_list[0], 0);
  EXPECT_GT(refined(lists, {5, 0}, 2'000).by_list[0], 1'000);
}

TEST(Lists, TheLeastLevelIsDoneWhateverTheBudgetAndTheGreatestNeverExceeded) {
  const std::vector<PriorityList> lists{{0.9, 2, 3}, {0.1, 0, 1}};
  for (const std::int64_t budget : {std::int64_t{0}, std::int64_t{500}, kUnlimitedTests}) {
    ManyPairs many(lists, {3, 3});
    FixedWork meter(budget);
    const WorkDone work = refine_by_lists(many.pairs, lists, meter);
    EXPECT_GE(work.floor, 6);
    EXPECT_LE(work.spent, std::max(budget, work.floor));
    for (const RefinedPair& pair : many.pairs) {
      const PriorityList& list = lists[static_cast<std::size_t>(pair.list)];
      EXPECT_GE(pair.refinement.level(), list.least_level) << "budget " << budget;
      EXPECT_LE(pair.refinement.level(), list.greatest_level) << "budget " << budget;
      if (budget == kUnlimitedTests) {
        EXPECT_EQ(pair.refinement.level(), list.greatest_level);
        EXPECT_EQ(pair.refinement.stop_reason(), StopReason::kGreatestLevel);
      }
      if (budget == 0) {
        EXPECT_EQ(pair.refinement.level(), list.least_level);
        EXPECT_EQ(pair.refinement.stop_reason(), StopReason::kBudgetSpent);
      }
    }
  }
}

StepInput looking_at(double x_m, double y_m, double radius_deg) {
  StepInput input = step_of(kStep_s);
  input.viewer = viewer_at({0.5, 0.3, 1600, 900, 3.0}, 0.0);
  input.fixation = ScreenPoint{x_m, y_m};
  input.region = GazeRegion{{x_m, y_m}, radius_deg};
  return input;
}

TEST(Lists, EverySchedulerWithAnUnlimitedBudgetEndsInTheSameState) {
  for (const std::string_view name : metric_names()) {
    World plain = enclosed_l_blocks(15, 3);
    MetricOptions options;
    if (needs_terms(name)) {
      options.terms = {{"eccentricity", 1.0, 0.0, 20.0}, {"size", 1.0, 5.0, 0.0}};
    }
    Schedule schedule;
    schedule.metric = make_metric(name, options);
    World other = enclosed_l_blocks(15, 3, schedule);
    World regional = enclosed_l_blocks(15, 3, by_region());
    std::size_t contacts = 0;
    for (int step = 0; step < 400; ++step) {
      FixedWork all(kUnlimitedTests);
      const StepReport report = plain.step(looking_at(0.1, 0.2, 5.0), all);
      ASSERT_EQ(other.step(looking_at(0.1, 0.2, 5.0), all).state.hash, report.state.hash) << name;
      ASSERT_EQ(regional.step(looking_at(0.1, 0.2, 5.0), all).state.hash, report.state.hash);
      contacts += report.collisions.size();
    }
    EXPECT_GT(contacts, 50U);
  }
}

TEST(Lists, ReplayWithTheLoggedGrantsAndGazeGivesTheSameHashes) {
  RandomStream random(63, "gaze");
  Schedule schedule = by_region(/*bad_level=*/1);
  schedule.lists[0].least_level = 2;
  World live = enclosed_l_blocks(15, 4, schedule);
  World replay = live;
  std::vector<int> in_list(2, 0);
  int stopped = 0;
  for (int step = 0; step < 2'400; ++step) {
    const StepInput input = looking_at(uniform_in(random, -0.3, 0.3), 0.0, 8.0);
    FixedWork budget(static_cast<std::int64_t>(random.below(2'000)));
    const StepReport shown = live.step(input, budget);
    FixedWork logged(shown.work_granted);
    const StepReport again = replay.step(input, logged);
    ASSERT_EQ(again.state.hash, shown.state.hash) << step;
    ASSERT_EQ(again.work_spent, shown.work_spent);
    ASSERT_EQ(again.list_work, shown.list_work);
    for (const CollisionReport& collision : shown.collisions) {
      ++in_list[static_cast<std::size_t>(collision.list)];
      stopped += collision.stop == StopReason::kGreatestLevel ? 1 : 0;
      ASSERT_TRUE(collision.list == 0 ? collision.level >= 2 : collision.level <= 1);
    }
  }
  EXPECT_GT(in_list[0], 20);
  EXPECT_GT(in_list[1], 20);
  EXPECT_GT(stopped, 20);
}

TEST(Lists, WhereTheViewerLooksDecidesWhatIsSimulated) {
  World here = enclosed_l_blocks(15, 3, by_region(/*bad_level=*/0));
  World there = here;
  bool differed = false;
  for (int step = 0; step < 200 && !differed; ++step) {
    FixedWork all(kUnlimitedTests);
    const std::uint64_t one = here.step(looking_at(0.3, 0.0, 6.0), all).state.hash;
    differed = there.step(looking_at(-0.3, 0.0, 6.0), all).state.hash != one;
  }
  EXPECT_TRUE(differed);
}

}  // namespace impetus::lists_test
