// `impetus trade`: what each kind of tree, level and reduction costs and errs, on a scene of the
// user's; written as a table.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/protocol/scene_loading.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus {
namespace {

struct TradeOptions {
  std::string scene;
  std::string out{"trade"};
  std::uint64_t seed{1};
  bool force{false};
};

/// Before anything is measured. Throws InputError.
void prepare_folder(const std::filesystem::path& folder, bool force) {
  std::error_code error;
  if (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder)) {
    throw InputError("--out: expected a folder, but " + folder.string() + " is a file");
  }
  if (!force && std::filesystem::exists(folder / "trade.csv")) {
    throw InputError((folder / "trade.csv").string() +
                     ": exists already and is not overwritten without --force");
  }
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError("--out: expected a folder to write to, could not make " + folder.string());
  }
}

int trade(const TradeOptions& options) {
  const JsonDocument scene = load_scene(options.scene);
  const std::filesystem::path folder = options.out;
  prepare_folder(folder, options.force);
  std::vector<TradeRow> rows;  // each part adds its own
  write_whole_file(folder / "trade.csv", csv_of(rows));
  std::printf("written to %s\n", (folder / "trade.csv").string().c_str());
  return kDone;
}

}  // namespace

void add_trade(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<TradeOptions>();
  CLI::App* command = app.add_subcommand(
      "trade", "Measure speed against accuracy on a scene, and advise what to choose");
  command->add_option("scene", options->scene, "Scene file")->required();
  command->add_option("--out", options->out, "The folder to write to")->capture_default_str();
  command->add_option("--seed", options->seed, "Another number, other poses")
      ->capture_default_str();
  command->add_flag("--force", options->force, "Overwrite an existing result");
  command->callback([options, &chosen] { chosen = [options] { return trade(*options); }; });
}

}  // namespace impetus
