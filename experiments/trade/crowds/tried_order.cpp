// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/tried_order.hpp"

#include <algorithm>
#include <memory>
#include <string_view>

#include "engine/numerics/random_stream.hpp"
#include "engine/scheduling/metrics.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline trade {
namespace {

/// A number in [0, 1) for each pair, whatever it does.
class RandomMetric final : public PriorityMetric {
 public:
  explicit RandomMetric(std::uint64_t seed) : PriorityMetric(Urgent::kLarge), seed_(seed) {}

  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                               const Fixation& /*fixation*/) const override {
    constexpr double kUnit = 0x1p-53;
    const std::uint64_t of_a = fold_bits(seed_, static_cast<std::uint32_t>(bounds.pair.a));
    const std::uint64_t bits = fold_bits(of_a, static_cast<std::uint32_t>(bounds.pair.b));
    return kUnit * static_cast<double>(bits >> 11);
  }

 private:
  std::uint64_t seed_;
};

std::string quoted_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  }
  return list;
}

void require_known(const std::string& scheduler, const StagedScene& scene) {
  const std::vector<std::string> known = schedulers_for(scene);
  if (std::find(known.begin(), known.end(), scheduler) == known.end()) {
    throw InputError("schedulers: expected some of " + quoted_list(known) + ", got \"" + scheduler +
                     "\"");
  }
}

}  // namespace

std::vector<std::string> tried_traversals(const std::vector<std::string>& asked) {
  std::vector<std::string> known;
  for (const std::string_view name : traversal_names()) {
    known.emplace_back(name);
  }
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw InputError("traversals: expected some of " + quoted_list(known) + ", got \"" + name +
                       "\"");
    }
  }
  return asked.empty() ? known : asked;
}

std::vector<std::string> schedulers_for(const StagedScene& scene) {
  std::vector<std::string> names{kOwnScheduler, kRandomScheduler};
  for (const std::string_view name : metric_names()) {
    if (!needs_terms(name) || !scene.metric_options.terms.empty()) {
      names.emplace_back(name);
    }
  }
  return names;
}

std::vector<TriedOrder> tried_orders(const StagedScene& scene,
                                     const std::vector<std::string>& schedulers,
                                     const std::vector<std::string>& traversals) {
  std::vector<TriedOrder> orders;
  for (const std::string& scheduler : schedulers) {
    require_known(scheduler, scene);
    if (scheduler == kOwnScheduler) {
      const Schedule& own = scene.world.settings().schedule;
      orders.push_back({scheduler, std::string(traversal_name(*own.traversal))});
      continue;
    }
    for (const std::string& traversal : traversals) {
      orders.push_back({scheduler, traversal});
    }
  }
  return orders;
}

Schedule schedule_of(const TriedOrder& order, const StagedScene& scene, std::uint64_t seed) {
  Schedule schedule;
  if (order.scheduler == kOwnScheduler) {
    schedule = scene.world.settings().schedule;
    schedule.persistence_steps = 0;
    return schedule;
  }
  schedule.traversal = make_traversal(order.traversal);
  schedule.metric =
      order.scheduler == kRandomScheduler
          ? std::make_shared<RandomMetric>(seed)
          : make_metric(order.scheduler, options_for(order.scheduler, scene.metric_options));
  return schedule;
}

}  // namespace impetus::inline trade
