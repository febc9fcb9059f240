// Crowds that orders of work are tried on in tests, and what became of them.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/ports.hpp"
#include "experiments/trade/crowds/crowd_rows.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus {

/// L-blocks of four levels that fill their cube.
inline json dense_crowd(int count = 40) {
  json scene = crowd_scene();
  scene["engine"] = {{"step_hz", 60}, {"restitution", 1}, {"tree_depth", 3}};
  scene["crowd"]["count"] = count;
  scene["enclosure"] = {{"edge_deg", 16}};
  scene["duration_s"] = 3;
  return scene;
}

inline CrowdTrade tried(const StagedScene& scene, const std::vector<std::string>& schedulers,
                        const std::vector<std::string>& traversals, std::uint64_t seed = 1) {
  CrowdRequest request;
  request.orders = tried_orders(scene, schedulers, traversals);
  request.sampled_every_s = 0.2;
  request.seed = seed;
  return crowd_trade(scene, request, SteadyClock());
}

/// Sums over the sampled steps of one order and budget.
template <typename Value>
double sum_of(const OrderedCrowd& ordered, const Value& value) {
  double sum = 0.0;
  for (const OrderedStep& step : ordered.steps) {
    sum += static_cast<double>(value(step));
  }
  return sum;
}

/// The budgets of one order, rising.
inline std::vector<const OrderedCrowd*> budgets_of(const CrowdTrade& trade,
                                                   const std::string& scheduler,
                                                   const std::string& traversal) {
  std::vector<const OrderedCrowd*> budgets;
  for (const OrderedCrowd& ordered : trade.orders) {
    if (ordered.order.scheduler == scheduler && ordered.order.traversal == traversal) {
      budgets.push_back(&ordered);
    }
  }
  return budgets;
}

}  // namespace impetus
