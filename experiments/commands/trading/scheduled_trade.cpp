// SPDX-License-Identifier: MIT
#include "experiments/commands/trading/scheduled_trade.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "engine/scheduling/named_kinds.hpp"
#include "experiments/commands/power/power_options.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/trading/parting_chunks.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/settings/optional_json.hpp"
#include "experiments/trade/crowds/crowd_rows.hpp"
#include "experiments/trade/crowds/cut_trade.hpp"
#include "experiments/trade/parting.hpp"
#include "experiments/trade/trial_starts.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

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

bool is_crowd(const StagedScene& scene) {
  constexpr std::size_t kFewest = 3;
  return scene.world.models().size() >= kFewest;
}

/// Of the crowd; its budgets are those asked for, or what the scene needs.
CrowdRequest crowd_request(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                           const StagedScene& scene) {
  CrowdRequest request;
  request.orders = orders_of(options, scene);
  request.budgets = options.budgets;
  request.seed = trade.seed;
  std::sort(request.budgets.begin(), request.budgets.end());
  const auto last = std::unique(request.budgets.begin(), request.budgets.end());
  request.budgets.erase(last, request.budgets.end());
  if (request.budgets.empty() && is_crowd(scene)) {
    request.budgets = usual_budgets(scene, request);
  }
  return request;
}

std::vector<TradeRow> crowd_part(const ScheduledTrade& trade, const CrowdRequest& request,
                                 const StagedScene& scene) {
  ProgressLine line("orders of work");
  return crowd_rows(
      crowd_trade(scene, request, SteadyClock(), [&line](double share) { line.tell(share); }),
      scene_title(trade.scene));
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

json setting_json(const PartingSetting& setting) {
  return {setting.kind, setting.level, setting.order.scheduler, setting.order.traversal,
          setting.budget};
}

PartingWork parting_work(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                         const std::vector<std::int64_t>& budgets) {
  PartingWork work;
  work.request.settings = settings_of(trade, options, budgets);
  work.request.starts = options.starts;
  work.request.thresholds = {options.parted_deg, options.parted_turn_deg};
  work.request.seed = trade.seed;
  json settings = json::array();
  for (const PartingSetting& setting : work.request.settings) {
    settings.push_back(setting_json(setting));
  }
  work.question = {{"scene", content_hash(trade.scene.value.dump())},
                   {"screen", screen_json(trade.screen)},
                   {"choice of trees, levels, orders or budgets", settings},
                   {"number of starts", options.starts},
                   {"--parted-deg", options.parted_deg},
                   {"--parted-turn-deg", options.parted_turn_deg},
                   {"seed", trade.seed}};
  return work;
}

StartOf start_of(const TrialStarts& starts) {
  return [&starts](const std::string& kind, std::int64_t number) {
    return starts.staged(kind, number);
  };
}

/// Tried here, or read from chunks.
std::vector<TradeRow> parting_part(const ScheduledTrade& trade, const PartingWork& work,
                                   const TrialStarts& starts) {
  if (trade.chunks > 0) {
    return parting_rows(gathered_partings(trade.out, trade.chunks, work), scene_title(trade.scene));
  }
  ProgressLine line("whole trials");
  return parting_rows(
      partings(start_of(starts), work.request, [&line](double share) { line.tell(share); }),
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
  const CrowdRequest crowd = crowd_request(trade, options, scene);
  std::vector<TradeRow> rows;
  if (options.starts > 0) {
    rows = parting_part(trade, parting_work(trade, options, crowd.budgets), starts);
  }
  if (is_crowd(scene)) {
    std::vector<TradeRow> all = crowd_part(trade, crowd, scene);
    const std::vector<TradeRow> cut = cut_part(trade, options, scene);
    all.insert(all.end(), cut.begin(), cut.end());
    rows.insert(rows.begin(), all.begin(), all.end());
  }
  return rows;
}

int do_trade_chunks(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                    const ChunkOptions& chunks, ShapeLibrary& shapes) {
  const TrialStarts starts(trade.scene.value, trade.screen, shapes, trade.seed);
  const CrowdRequest crowd = crowd_request(trade, options, starts.staged("", 1));
  const PartingWork work = parting_work(trade, options, crowd.budgets);
  return chunks.list ? list_partings(trade.out, chunks, work)
                     : do_parting_chunk(trade.out, chunks, work, start_of(starts));
}

}  // namespace impetus::inline commands
