// The goal of priority scheduling in crowds, and trials of every kind of tree.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/trade/parting.hpp"
#include "experiments/trade/trial_starts.hpp"
#include "tests/experiments/crowded_trade.hpp"

namespace impetus::crowd_trade_slow_test {

TEST(CrowdTradeSlow, VisibleFirstRemovesAThirdMoreThanBreadthFirstAmongCreatures) {
  json scene = json::parse(shipped("stimuli/creatures-in-a-cube.json"));
  scene["duration_s"] = 4;
  const CrowdTrade trade =
      tried(built(scene), {"eccentricity"}, {"visible-first", "breadth-first"});
  const std::int64_t all = trade.orders.back().budget;
  for (const OrderedCrowd* ordered : budgets_of(trade, "eccentricity", "visible-first")) {
    const double removed = sum_of(*ordered, [](const auto& step) { return step.removed.gap; });
    const double broad = sum_of(*ordered, [](const auto& step) { return step.breadth_first.gap; });
    // Up to a quarter of all the work; beyond it little is left for any order.
    EXPECT_GT(removed, (4 * ordered->budget <= all ? 1.3 : 0.99) * broad) << ordered->budget;
  }
}

TEST(PartingSlow, ComesLaterWithTheLevelForEveryKindOfTree) {
  json scene = crowd_scene();
  scene["engine"] = {{"step_hz", 120}, {"restitution", 1}, {"tree_depth", 2}};
  scene["crowd"]["count"] = 6;
  scene["enclosure"] = {{"edge_deg", 10}};
  scene["duration_s"] = 4;
  ShapeLibrary library;
  const TrialStarts starts(scene, assumed_screen(), library, 1);
  PartingRequest request;
  request.starts = 10;
  for (const std::string& kind : tree_kind_names()) {
    for (const int level : {0, 1, 2}) {
      request.settings.push_back({kind, level, {"distance"}, {}});
    }
  }
  const auto parted = partings(
      [&](const std::string& kind, std::int64_t number) { return starts.staged(kind, number); },
      request);
  const auto mean_half_s = [&](const PartedTrials& trials) {
    double sum = 0.0;
    for (const PartedTrial& trial : trials.trials) {
      sum += std::min(trial.half_s, 4.0);
    }
    return sum / static_cast<double>(trials.trials.size());
  };
  for (std::size_t kind = 0; kind < parted.size(); kind += 3) {
    EXPECT_LT(mean_half_s(parted[kind]), mean_half_s(parted[kind + 1]) + 1e-9)
        << parted[kind].setting.kind;
    EXPECT_LT(mean_half_s(parted[kind + 1]), 4.0 + 1e-9);
    EXPECT_EQ(mean_half_s(parted[kind + 2]), 4.0) << "its own finest level";
  }
}

}  // namespace impetus::crowd_trade_slow_test
