// The parts of `impetus trade` in which work is scheduled: crowds, and whole trials.
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline commands {

/// What the command line asks of them; empty lists stand for what is usual.
struct ScheduledTradeOptions {
  std::vector<std::string> schedulers;
  std::vector<std::string> traversals;
  std::vector<std::int64_t> budgets;  ///< units of work on tests beyond the floor, a step
  int starts{3};                      ///< of whole trials
  double parted_deg{0.5};
  double parted_turn_deg{10.0};
  std::vector<std::string> kinds;  ///< of trees in whole trials; none: the scene's own
};

/// The name of the scene's file without its ending.
std::string scene_title(const JsonDocument& scene);

void add_options(CLI::App& command, ScheduledTradeOptions& options);

/// What the schedulers are tried on, and with which trees and levels.
struct ScheduledTrade {
  const JsonDocument& scene;
  ScreenGeometry screen;
  std::vector<int> levels;  ///< none: all but the finest
  std::uint64_t seed{1};
  std::int64_t chunks{0};     ///< from which whole trials are read; 0: they are tried here
  std::filesystem::path out;  ///< where these are
};

/// Throws InputError when an option is out of range, before anything is measured.
void check(const ScheduledTradeOptions& options, const StagedScene& scene);

/// Lists the chunks of the whole trials, or computes the one that was asked for.
int do_trade_chunks(const ScheduledTrade& trade, const ScheduledTradeOptions& options,
                    const ChunkOptions& chunks, ShapeLibrary& shapes);

/// The rows of both parts, with progress on standard error. Two bodies are no crowd: they have no
/// rows of that part.
std::vector<TradeRow> scheduled_trade_rows(const ScheduledTrade& trade,
                                           const ScheduledTradeOptions& options,
                                           ShapeLibrary& shapes);

}  // namespace impetus::inline commands
