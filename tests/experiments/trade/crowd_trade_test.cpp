// What orders of work remove of a crowd's visible error.
// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/crowd_trade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/run/collision_truth.hpp"
#include "experiments/trade/crowds/removal_curve.hpp"
#include "tests/experiments/crowded_trade.hpp"

namespace impetus::crowd_trade_test {

constexpr std::array kErrors{&VisibleError::gap, &VisibleError::bound};
constexpr double kRounding = 1e-9;

const StagedScene& dense() {
  static const StagedScene scene = built(dense_crowd());
  return scene;
}

/// Every scheduler and traversal on the dense crowd, once for all tests.
const CrowdTrade& all_tried() {
  static const CrowdTrade trade = tried(dense(), schedulers_for(dense()), tried_traversals({}));
  return trade;
}

TEST(CrowdTrade, ErrorLeftFallsWithTheBudgetOnAverageForEveryOrder) {
  ASSERT_FALSE(all_tried().orders.empty());
  const std::int64_t least = all_tried().orders.front().budget;
  for (const OrderedCrowd& first : all_tried().orders) {
    if (first.budget != least || first.order.scheduler == kOwnScheduler) {
      continue;
    }
    const auto budgets = budgets_of(all_tried(), first.order.scheduler, first.order.traversal);
    ASSERT_GT(budgets.size(), 3U);
    for (const ErrorOf error : kErrors) {
      const auto left = [&](const OrderedCrowd* ordered) {
        return sum_of(*ordered, [&](const OrderedStep& step) { return step.left.*error; });
      };
      for (std::size_t i = 1; i < budgets.size(); ++i) {
        // A wall that a finer level finds may add what its coarser one did not have.
        EXPECT_LE(left(budgets[i]), 1.001 * left(budgets[i - 1]))
            << first.order.scheduler << ", budget " << budgets[i]->budget;
      }
      EXPECT_LT(left(budgets.back()), 0.5 * left(budgets.front())) << first.order.scheduler;
    }
  }
}

TEST(CrowdTrade, HindsightIsNeverBeatenWithAsMuchWork) {
  for (const OrderedCrowd& ordered : all_tried().orders) {
    for (const OrderedStep& step : ordered.steps) {
      for (const ErrorOf error : kErrors) {
        EXPECT_LE(step.removed.*error, step.in_hindsight.*error + kRounding)
            << ordered.order.scheduler << ", budget " << ordered.budget;
        EXPECT_LE(step.by_chance.*error, step.in_hindsight.*error + kRounding);
        EXPECT_LE(step.breadth_first.*error, step.in_hindsight.*error + kRounding);
      }
    }
  }
}

TEST(CrowdTrade, NoOrderSpendsMoreThanItsBudget) {
  for (const OrderedCrowd& ordered : all_tried().orders) {
    for (const OrderedStep& step : ordered.steps) {
      EXPECT_GE(step.work, 0);
      EXPECT_LE(step.work, ordered.budget);
    }
  }
}

TEST(CrowdTrade, RandomOrderIsWorseThanHindsight) {
  for (const OrderedCrowd* ordered : budgets_of(all_tried(), kRandomScheduler, "depth-first")) {
    const double removed = sum_of(*ordered, [](const auto& step) { return step.removed.gap; });
    const double most = sum_of(*ordered, [](const auto& step) { return step.in_hindsight.gap; });
    const bool all = ordered->budget == all_tried().orders.back().budget;
    EXPECT_LT(removed, (all ? 1.0 : 0.8) * most) << ordered->budget;
  }
}

TEST(CrowdTrade, TheEnginesOwnBreadthFirstRemovesWhatTheReferenceSays) {
  double removed = 0.0;
  double expected = 0.0;
  for (const OrderedCrowd* ordered : budgets_of(all_tried(), kRandomScheduler, "breadth-first")) {
    removed += sum_of(*ordered, [](const auto& step) { return step.removed.bound; });
    expected += sum_of(*ordered, [](const auto& step) { return step.breadth_first.bound; });
  }
  // One random order against the mean of sixteen.
  EXPECT_NEAR(removed / expected, 1.0, 0.1);
}

TEST(CrowdTrade, WorkWithoutEndLeavesWhatTheFinestLevelsLeave) {
  CrowdRequest request;
  request.orders = tried_orders(dense(), {"eccentricity"}, {"visible-first"});
  request.budgets = {1'000'000'000};
  request.sampled_every_s = 0.5;
  const CrowdTrade trade = crowd_trade(dense(), request, SteadyClock());
  ASSERT_EQ(trade.steps.size(), 6U);
  for (std::size_t i = 0; i < trade.steps.size(); ++i) {
    const OrderedStep& step = trade.orders.front().steps[i];
    EXPECT_EQ(step.work, trade.steps[i].finest_work);
    for (const ErrorOf error : kErrors) {
      EXPECT_NEAR(step.left.*error, trade.steps[i].at_finest.*error, kRounding);
    }
  }
}

TEST(CrowdTrade, VisibleFirstRemovesMoreThanBreadthFirstAtEveryBudgetButAll) {
  for (const char* scheduler : {"eccentricity", "distance"}) {
    for (const OrderedCrowd* ordered : budgets_of(all_tried(), scheduler, "visible-first")) {
      const double removed = sum_of(*ordered, [](const auto& step) { return step.removed.gap; });
      const double broad =
          sum_of(*ordered, [](const auto& step) { return step.breadth_first.gap; });
      const bool half_or_more = 4 * ordered->budget > all_tried().orders.back().budget;
      EXPECT_GT(removed, (half_or_more ? 0.99 : 1.3) * broad) << ordered->budget;
    }
  }
}

TEST(CrowdTrade, TheSameSeedGivesTheSameTableButTimes) {
  const auto table = [&](std::uint64_t seed) {
    std::vector<TradeRow> rows =
        crowd_rows(tried(dense(), {"random", "eccentricity"}, {"best-first"}, seed), "dense");
    rows.erase(
        std::remove_if(rows.begin(), rows.end(), [](const TradeRow& row) { return row.by_clock; }),
        rows.end());
    return csv_of(rows);
  };
  EXPECT_EQ(table(1), table(1));
  EXPECT_NE(table(1), table(2));
}

TEST(CrowdTrade, EnergyIsKeptInEveryOrder) {
  for (const OrderedCrowd& ordered : all_tried().orders) {
    for (const OrderedStep& step : ordered.steps) {
      // Momenta are exact; the midpoint rule turns bodies with an error of this order a step.
      EXPECT_NEAR(step.energy_change, 0.0, 1e-4);
    }
  }
}

TEST(CrowdTrade, AMetricThatIsNotThereIsRefusedWithTheNamesThereAre) {
  const std::string sentence = refusal([] { tried_orders(dense(), {"beauty"}, {}); });
  EXPECT_TRUE(sentence.starts_with("schedulers: expected some of \"scene\", \"random\""))
      << sentence;
  EXPECT_TRUE(sentence.ends_with(", got \"beauty\"")) << sentence;
  EXPECT_EQ(refusal([] { tried_traversals({"sideways"}); }),
            "traversals: expected some of \"depth-first\", \"breadth-first\", \"best-first\", "
            "\"visible-first\", got \"sideways\"");
}

TEST(PairLevels, AreWhatEachLevelLeavesOfTheGapWhereOneLooks) {
  // Two L-blocks whose bounds meet; the eye looks at them, then ten degrees aside.
  const json scene = dense_crowd(2);
  const StagedScene staged = built(scene);
  const double radius_m = staged.world.models()[0].tree->bounding_radius_m();
  const std::vector<Pose> poses{{Vector3(-0.8 * radius_m, 0, 0), Quaternion::Identity()},
                                {Vector3(0.8 * radius_m, 0, 0), Quaternion::Identity()}};
  const double gap_arcmin =
      measure_truth(staged.looks[0], poses[0], staged.looks[1], poses[1], staged.viewer)
          .visible_arcmin();
  ASSERT_GT(gap_arcmin, 0.0);
  const auto levels_at = [&](double aside_deg) {
    return pair_levels(staged, poses, {staged.viewer, ScreenPoint{metres_of(aside_deg), 0.0}});
  };
  const auto central = levels_at(0.0);
  ASSERT_EQ(central.size(), 1U);
  const auto& levels = central.front().levels;
  EXPECT_EQ(levels.front().work, 0);
  EXPECT_NEAR(levels.front().left.gap, gap_arcmin, 1e-9);
  EXPECT_EQ(levels.back().left.gap, 0.0) << "the finest level sees that they are apart";
  EXPECT_GT(levels.back().work, 0);
  // Half the acuity is left at 2.3°; metres of screen per degree differ from degrees by less.
  EXPECT_NEAR(levels_at(2.3).front().levels.front().left.gap / gap_arcmin, 0.5, 1e-3);
}

}  // namespace impetus::crowd_trade_test
