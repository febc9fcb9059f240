// SPDX-License-Identifier: MIT
#include "experiments/commands/scheduled_trade.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "engine/scheduling/named_kinds.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/trade/crowds/crowd_rows.hpp"
#include "experiments/trade/crowds/cut_trade.hpp"
#include "experiments/trade/parting.hpp"
#include "experiments/trade/trial_starts.hpp"

namespace impetus::inline commands {
namespace {

constexpr std::size_t kFewestOfACrowd = 3;

std::vector<TriedOrder> orders_of(const ScheduledTradeOptions& options, const StagedScene& scene) {
  return tried_orders(scene,
                      options.schedulers.empty() ? schedulers_for(scene) : options.schedulers,
                      tried_traversals(options.traversals));
}

/// As asked for; else all but the finest, which is the reference.
std::vector<int> levels_of(const ScheduledTrade& trade) {
  std::vector<int> levels = trade.levels;
  const int depth = trade.scene.value["engine"].value("tree_depth", 0);
  for (int level = 0; trade.levels.empty() && level < depth; ++level) {
    levels.push_back(level);
  }
  return levels;
}

/// The least of the budgets, the middle one and the greatest, for whole trials take long.
std::vector<std::int64_t> few_of(const std::vector<std::int64_t>& budgets) {
  constexpr std::size_t kFew = 3;
  return budgets.size() <= kFew ? budgets
                                : std::vector<std::int64_t>{
                                      budgets.front(), budgets[budgets.size() / 2], budgets.back()};
}

/// Every kind and level without a budget; and, with the scene's own trees, each traversal by
/// eccentricity within each budget.
std::vector<PartingSetting> settings_of(const ScheduledTrade& trade,
                                        const ScheduledTradeOptions& options,
                                        const std::vector<std::int64_t>& budgets) {
  std::vector<PartingSetting> settings;
  const std::vector<std::string> own{""};
  for (const std::string& kind : options.kinds.empty() ? own : options.kinds) {
    for (const int level : levels_of(trade)) {
      settings.push_back({kind, level, {"distance"}, {}});
    }
  }
  for (const std::string& traversal : tried_traversals(options.traversals)) {
    for (const std::int64_t budget : few_of(budgets)) {
      settings.push_back({"", kUnlimitedLevel, {"eccentricity", traversal}, budget});
    }
  }
  return settings;
}

std::vector<TradeRow> crowd_part(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                                 const StagedScene& scene, std::vector<std::int64_t>& budgets) {
  ProgressLine line("orders of work");
  CrowdRequest request;
  request.orders = orders_of(options, scene);
  request.budgets = budgets;
  request.seed = trade.seed;
  const CrowdTrade crowd =
      crowd_trade(scene, request, SteadyClock(), [&line](double share) { line.tell(share); });
  budgets.clear();
  for (const OrderedCrowd& ordered : crowd.orders) {
    if (budgets.empty() || budgets.back() != ordered.budget) {
      budgets.push_back(ordered.budget);
    }
  }
  return crowd_rows(crowd, scene_title(trade.scene));
}

/// Phases cut one by one, by the scene's own order, by eccentricity and by chance.
std::vector<TradeRow> cut_part(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                               const StagedScene& scene) {
  ProgressLine line("steps cut short");
  CutRequest request;
  request.orders = {{kOwnScheduler}, {"eccentricity"}, {kRandomScheduler}};
  request.thresholds = {options.parted_deg, options.parted_turn_deg};
  request.seed = trade.seed;
  return cut_rows(cut_trade(scene, request, [&line](double share) { line.tell(share); }),
                  request.orders, scene_title(trade.scene));
}

std::vector<TradeRow> parting_part(const ScheduledTrade& trade,
                                   const ScheduledTradeOptions& options, const TrialStarts& starts,
                                   const std::vector<std::int64_t>& budgets) {
  ProgressLine line("whole trials");
  PartingRequest request;
  request.settings = settings_of(trade, options, budgets);
  request.starts = options.starts;
  request.thresholds = {options.parted_deg, options.parted_turn_deg};
  request.seed = trade.seed;
  const StartOf start = [&](const std::string& kind, std::int64_t number) {
    return starts.staged(kind, number);
  };
  return parting_rows(partings(start, request, [&line](double share) { line.tell(share); }),
                      scene_title(trade.scene));
}

}  // namespace

std::string scene_title(const JsonDocument& scene) {
  return std::filesystem::path(scene.name).stem().string();
}

void add_options(CLI::App& command, ScheduledTradeOptions& options) {
  command
      .add_option("--schedulers", options.schedulers,
                  "Metrics by name, random, scene (its own); all")
      ->delimiter(',');
  command
      .add_option("--traversals", options.traversals,
                  "Of " + list_names(traversal_names()) + "; all")
      ->delimiter(',');
  command
      .add_option("--budgets", options.budgets,
                  "Units of work a step, beyond what no order can spare; by the scene's need")
      ->delimiter(',');
  command
      .add_option("--starts", options.starts,
                  "Of whole trials, until they part from the finest level's; 0: none")
      ->capture_default_str();
  command.add_option("--parted-deg", options.parted_deg, "As far apart is seen to be elsewhere")
      ->capture_default_str();
  command.add_option("--parted-turn-deg", options.parted_turn_deg, "The same of a turn")
      ->capture_default_str();
}

void check(const ScheduledTradeOptions& options, const StagedScene& scene) {
  static_cast<void>(orders_of(options, scene));
  for (const std::int64_t budget : options.budgets) {
    if (budget < 1) {
      throw InputError("--budgets: expected units of work from 1, got " + std::to_string(budget));
    }
  }
  if (options.starts < 0 || options.starts > 1000) {
    throw InputError("--starts: expected from 0 to 1000, got " + std::to_string(options.starts));
  }
  if (!(options.parted_deg > 0.0) || !(options.parted_turn_deg > 0.0)) {
    throw InputError("--parted-deg, --parted-turn-deg: expected degrees above 0");
  }
}

std::vector<TradeRow> scheduled_trade_rows(const ScheduledTrade& trade,
                                           const ScheduledTradeOptions& options,
                                           ShapeLibrary& shapes) {
  const TrialStarts starts(trade.scene.value, trade.screen, shapes, trade.seed);
  const StagedScene scene = starts.staged("", 1);
  std::vector<std::int64_t> budgets = options.budgets;
  std::sort(budgets.begin(), budgets.end());
  std::vector<TradeRow> rows;
  if (scene.world.models().size() >= kFewestOfACrowd) {
    rows = crowd_part(trade, options, scene, budgets);
    const std::vector<TradeRow> cut = cut_part(trade, options, scene);
    rows.insert(rows.end(), cut.begin(), cut.end());
  }
  if (options.starts > 0) {
    std::vector<TradeRow> more = parting_part(trade, options, starts, budgets);
    std::move(more.begin(), more.end(), std::back_inserter(rows));
  }
  return rows;
}

}  // namespace impetus::inline commands
