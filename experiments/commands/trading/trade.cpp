// `impetus trade`: what each kind of tree, level and reduction costs and errs, on a scene of the
// user's; as a table, a figure and advice.
//
//   scene ──simulate──> who meets, how fast, how many pairs ──random impacts──> rows
//   rows ──budgets──> choices, each run in the scene ──> advice, settings to paste
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/given_words.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/commands/trading/scheduled_trade.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/scenes/scene_checks.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/text_table.hpp"
#include "experiments/trade/crowds/cut_trade.hpp"
#include "experiments/trade/embedded_trade_script.hpp"
#include "experiments/trade/impacts/impact_rows.hpp"
#include "experiments/trade/impacts/scene_pairs.hpp"
#include "experiments/trade/scene_demand.hpp"
#include "experiments/trade/trade_choice.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

/// What `impetus trade` was asked for.
struct TradeOptions : ChunkOptions {
  std::string scene;
  std::string out{"trade"};
  std::string screen_file;
  std::vector<std::string> kinds;
  std::vector<int> levels;
  std::vector<std::string> reductions;
  std::vector<double> budgets_ms{1.0, 4.0, 16.0, 50.0};
  int depth{-1};
  int impacts{200};
  std::uint64_t seed{1};
  bool force{false};
  ScheduledTradeOptions scheduled;
};

constexpr int kUsualDepth = 3;
constexpr int kGreatestSceneDepth = 6;
constexpr std::size_t kMostPairs = 6;
const std::vector<std::string> kTradeFiles{"trade.csv",   "trade.R",    "trade.svg",    "trade.pdf",
                                           "choices.csv", "choices.md", "choices.json", "cut.md"};

std::vector<std::string> all_reductions() {
  const auto names = reduction_names();
  return {names.begin(), names.end()};
}

void require_names(const char* option, const std::vector<std::string>& given,
                   const std::vector<std::string>& known) {
  for (const std::string& name : given) {
    require(std::find(known.begin(), known.end(), name) != known.end(),
            std::string(option) + ": expected some of " + listed(known) + ", got " + name);
  }
}

void check(const TradeOptions& options) {
  require_names("--kinds", options.kinds, tree_kind_names());
  require_names("--reductions", options.reductions, all_reductions());
  const std::string range = std::to_string(kGreatestSceneDepth);
  require(options.depth >= -1 && options.depth <= kGreatestSceneDepth,
          "--depth: expected from 0 to " + range + ", got " + std::to_string(options.depth));
  for (const int level : options.levels) {
    require(level >= 0 && level <= kGreatestSceneDepth,
            "--levels: expected from 0 to " + range + ", got " + std::to_string(level));
  }
  require(options.impacts >= 10 && options.impacts <= 100'000,
          "--impacts: expected from 10 to 100000, got " + std::to_string(options.impacts));
  for (const double budget_ms : options.budgets_ms) {
    require(budget_ms > 0.0,
            "--budgets-ms: expected milliseconds above 0, got " + csv_number(budget_ms));
  }
}

/// What the parts work on.
struct Trade {
  const JsonDocument& scene;
  const TradeOptions& options;
  ScreenGeometry screen;
  int depth{0};
  StagedScene staged;
  SceneDemand demand;
};

int depth_of(const TradeOptions& options, const json& scene) {
  if (options.depth >= 0) {
    return options.depth;
  }
  int depth = std::max(kUsualDepth, scene["engine"].value("tree_depth", 0));
  for (const int level : options.levels) {
    depth = std::max(depth, level);
  }
  return depth;
}

bool are_balls(const TradeBodies& bodies) {
  return std::all_of(bodies.alike.begin(), bodies.alike.end(),
                     [](const ImpactBody& body) { return body.look.mesh == nullptr; });
}

std::vector<ScenePair> pairs_of(const Trade& trade, std::vector<TreeKind>& kinds,
                                ShapeLibrary& shapes) {
  ProgressLine line("building trees");
  shapes.tell([&line](double share) { line.tell(share); });
  const TradeBodies bodies =
      trade_bodies(trade.scene.value, metres_per_degree(trade.screen.viewing_distance_m), kinds,
                   trade.depth, shapes);
  shapes.tell({});
  if (are_balls(bodies)) {  // a ball is its own tree, whatever the kind
    kinds.resize(1);
  }
  return scene_pairs(bodies, trade.demand, trade.staged, kMostPairs);
}

/// So that a pair counts as often as it meets, and none too little to say anything.
int impacts_of(const ScenePair& pair, std::int64_t meetings, int impacts) {
  constexpr int kFewest = 20;
  return std::max(std::min(kFewest, impacts), static_cast<int>(impacts * pair.meetings / meetings));
}

std::vector<ImpactMeasures> measure_pairs(const Trade& trade, ShapeLibrary& shapes) {
  ImpactSettings settings;
  for (const std::string& kind : trade.options.kinds) {
    settings.kinds.push_back(tree_kind(kind));
  }
  const std::vector<ScenePair> pairs = pairs_of(trade, settings.kinds, shapes);
  require(!pairs.empty(),
          trade.scene.name + ": expected two bodies that can meet, got none of which one can move");
  settings.levels = trade.options.levels;
  for (int level = 0; trade.options.levels.empty() && level <= trade.depth; ++level) {
    settings.levels.push_back(level);
  }
  settings.reductions = trade.options.reductions;
  settings.seed = trade.options.seed;
  std::int64_t meetings = 0;
  for (const ScenePair& pair : pairs) {
    meetings += pair.meetings;
  }
  std::vector<ImpactMeasures> measures;
  const ThreadClock clock;
  for (const ScenePair& pair : pairs) {
    ProgressLine line("impacts of " + pair.pair.name());
    settings.impacts = impacts_of(pair, meetings, trade.options.impacts);
    measures.push_back(
        measure_impacts(pair.pair, settings, clock, [&line](double share) { line.tell(share); }));
  }
  return measures;
}

void append(std::vector<TradeRow> more, std::vector<TradeRow>& rows) {
  std::move(more.begin(), more.end(), std::back_inserter(rows));
}

/// The part of impacts: its rows, and the measures to choose by.
ImpactMeasures add_impacts(const Trade& trade, ShapeLibrary& shapes, std::vector<TradeRow>& rows) {
  const std::vector<ImpactMeasures> measures = measure_pairs(trade, shapes);
  for (const ImpactMeasures& each : measures) {
    append(impact_rows(each), rows);
  }
  if (measures.size() == 1) {
    return measures.front();
  }
  ImpactMeasures all = pooled(measures, "all pairs");
  append(impact_rows(all), rows);
  return all;
}

/// Runs the scene as options say, each option once; each run adds its rows.
class SceneRuns {
 public:
  SceneRuns(const Trade& trade, ShapeLibrary& shapes, std::vector<TradeRow>& rows)
      : trade_(trade), shapes_(shapes), rows_(rows) {}

  /// The 95th percentile of the steps in which bodies touch (milliseconds).
  double step_ms(const TradeOption& option) {
    constexpr double kLongest_s = 2.0;
    const auto [known, is_new] =
        known_ms_.try_emplace({option.kind, option.level, option.reduction});
    if (is_new) {
      const StagedScene staged = build_scene(scene_with(trade_.scene.value, option, trade_.depth),
                                             trade_.screen, kUnroundedHold, shapes_);
      const std::vector<double> times_ms = step_times_ms(staged, clock_, kLongest_s);
      append(run_rows(scene_title(trade_.scene), option, times_ms), rows_);
      known->second = quantile_of(times_ms, 0.95).value;
    }
    return known->second;
  }

 private:
  const Trade& trade_;
  ShapeLibrary& shapes_;
  std::vector<TradeRow>& rows_;
  std::map<std::tuple<TreeKind, int, std::string>, double> known_ms_;
  ThreadClock clock_;
};

/// The options of kinds with which the scene is valid: bounds may be too large for a crowd's walls.
/// Those that it is not valid with are told.
std::vector<TradeOption> possible_options(const Trade& trade, std::vector<TradeOption> options) {
  for (const std::string& kind : trade.options.kinds) {
    TradeOption root;
    root.kind = tree_kind(kind);
    root.reduction = trade.options.reductions.front();
    const std::vector<SceneProblem> problems =
        scene_problems(scene_with(trade.scene.value, root, trade.depth));
    if (!problems.empty()) {
      std::printf("not offered: trees of kind %s, with which %s: %s\n", kind.c_str(),
                  problems.front().pointer.c_str(), problems.front().message.c_str());
      std::erase_if(options, [&](const TradeOption& each) { return each.kind == root.kind; });
    }
  }
  return options;
}

/// Every kind and level in the scene itself, with the first reduction asked for.
void run_every_level(const std::vector<TradeOption>& options, SceneRuns& runs) {
  ProgressLine line("running the scene at every level");
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].reduction == options.front().reduction) {
      runs.step_ms(options[i]);
    }
    line.tell(static_cast<double>(i + 1) / static_cast<double>(options.size()));
  }
}

std::vector<TradeChoice> choose(const Trade& trade, const std::vector<TradeOption>& options,
                                SceneRuns& runs) {
  ProgressLine line("running the scene with what was chosen");
  double done = 0.0;
  const RunScene run = [&](const TradeOption& option) {
    line.tell(done += 0.1);
    return runs.step_ms(option);
  };
  std::vector<double> budgets_ms = trade.options.budgets_ms;
  std::sort(budgets_ms.begin(), budgets_ms.end());
  return choices_for(budgets_ms, options, pairs_per_step(trade.demand), run);
}

std::string settings_text(const Trade& trade, const std::vector<TradeChoice>& choices) {
  json settings = json::object();
  for (const TradeChoice& choice : choices) {
    settings[csv_number(choice.budget_ms) + " ms"] = {
        {"engine", engine_with(trade.scene.value, choice.option, trade.depth)}};
  }
  return settings.dump(2) + "\n";
}

/// Writes the figure's script, trade.R, into `folder` beside trade.csv and runs it with Rscript.
/// What to tell the user: that trade.svg and trade.pdf are written, or what is missing and how to
/// make them then.
std::string draw_trade_figure(const std::filesystem::path& folder) {
  const std::string script = (folder / "trade.R").string();
  const std::string table = (folder / "trade.csv").string();
  write_whole_file(script, kTradeScriptText);
  const std::string by_hand = "Rscript " + script + " " + table;
  const std::filesystem::path figure = folder / "trade.svg";
  std::filesystem::remove(figure);
  const int status = run_r_script({script, table});
  if (status == 0 && std::filesystem::exists(figure)) {
    return "figure: " + figure.string() + ", " + (folder / "trade.pdf").string();
  }
  const std::string missing = status == kNoRscript ? "Rscript is missing" : "Rscript failed";
  return "no figure: " + missing + "; with R and ggplot2 (apt-get install r-cran-ggplot2), " +
         by_hand + " draws it";
}

void tell(const std::vector<TradeChoice>& choices, double pairs,
          const std::filesystem::path& folder) {
  std::printf("a step refines %s %s of bodies (95th percentile)\n", two_digits(pairs).c_str(),
              pairs == 1.0 ? "pair" : "pairs");
  std::string last;
  for (const TradeChoice& choice : choices) {
    const std::string words = words_for(choice.option);
    if (words != last || !choice.keeps) {  // what a larger budget leaves as it was says nothing new
      std::printf("%s\n", advice(choice).c_str());
    }
    last = words;
  }
  const bool has_cuts = std::filesystem::exists(folder / "cut.md");
  std::printf("written to %s: trade.csv, choices.md, choices.csv, choices.json%s\n%s\n",
              folder.string().c_str(), has_cuts ? ", cut.md" : "",
              draw_trade_figure(folder).c_str());
}

int trade(const JsonDocument& scene, const TradeOptions& options) {
  const std::filesystem::path folder = options.out;
  ShapeLibrary shapes;
  const ScreenGeometry screen = chosen_screen(options.screen_file);
  Trade trade{scene,
              options,
              screen,
              depth_of(options, scene.value),
              build_scene(scene.value, screen, kUnroundedHold, shapes),
              {}};
  check(options.scheduled, trade.staged);
  const ScheduledTrade scheduled{scene,        screen,         options.levels,
                                 options.seed, options.chunks, folder};
  if (options.list || options.chunk > 0) {
    return do_trade_chunks(scheduled, options.scheduled, options, shapes);
  }
  require_new_files(folder, kTradeFiles, options.force);
  make_out_folder(folder);
  {
    ProgressLine line("simulating the scene");
    trade.demand = demand_of(trade.staged, [&line](double share) { line.tell(share); });
  }
  std::vector<TradeRow> rows = scene_rows(trade.demand, scene_title(scene));
  const ImpactMeasures impacts = add_impacts(trade, shapes, rows);
  append(scheduled_trade_rows(scheduled, options.scheduled, shapes), rows);
  const std::vector<TradeOption> found = possible_options(trade, trade_options(impacts));
  SceneRuns runs(trade, shapes, rows);
  run_every_level(found, runs);
  const std::vector<TradeChoice> choices =
      found.empty() ? std::vector<TradeChoice>() : choose(trade, found, runs);
  const double pairs = pairs_per_step(trade.demand);
  write_whole_file(folder / "trade.csv", csv_of(rows));
  std::filesystem::remove(folder / "cut.md");
  if (const std::string page = cut_page(rows); !page.empty()) {
    write_whole_file(folder / "cut.md", page);
  }
  write_whole_file(folder / "choices.csv", choices_csv(choices));
  write_whole_file(folder / "choices.md", choices_page(choices, scene_title(scene), pairs));
  write_whole_file(folder / "choices.json", settings_text(trade, choices));
  tell(choices, pairs, folder);
  return kDone;
}

int load_and_trade(const TradeOptions& options) {
  const BuildingLine told;
  check(options);
  require(options.scheduled.starts >= 0,
          "--starts: expected 0 or more, got " + std::to_string(options.scheduled.starts));
  require_chunks(options, options.chunks, options.scheduled.starts, "start");
  const JsonDocument scene = load_scene(options.scene);
  return staged_from(scene, [&] { return trade(scene, options); });
}

}  // namespace

void add_trade(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<TradeOptions>();
  CLI::App* command = app.add_subcommand(
      "trade", "Measure speed against accuracy on a scene, and advise what to choose");
  command->add_option("scene", options->scene, "Scene file")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command->add_option("--out", options->out, "The folder to write to")->capture_default_str();
  command->add_option("--kinds", options->kinds, "Of " + listed(tree_kind_names()) + "; all")
      ->delimiter(',');
  command->add_option("--levels", options->levels, "Such as 0,2,3; all to the depth")
      ->delimiter(',');
  command
      ->add_option("--reductions", options->reductions, "Of " + listed(all_reductions()) + "; all")
      ->delimiter(',');
  command->add_option("--depth", options->depth,
                      "Of the trees; the scene's, at least 3, when left out");
  command->add_option("--budgets-ms", options->budgets_ms, "Milliseconds a step; 1,4,16,50")
      ->delimiter(',');
  command->add_option("--impacts", options->impacts, "To measure at, 10 to 100000")
      ->capture_default_str();
  add_options(*command, options->scheduled);
  command->add_option("--seed", options->seed, "Another number, other impacts")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{0}, kLargestSeed));
  command->add_option("--screen", options->screen_file,
                      "Screen file instead of the user's settings");
  command->add_flag("--force", options->force, "Overwrite an existing result");
  add_chunk_options(*command, *options,
                    "The whole trials in so many pieces, each a command of its own on any machine "
                    "that sees the folder; alone, reads all of them and measures the rest here");
  command->callback([options, command, &chosen] {
    options->repeated = given_words(*command, {"--chunk", "--list", "--force"});
    chosen = [options] {
      options->scheduled.kinds = options->kinds;
      if (options->kinds.empty()) {
        options->kinds = tree_kind_names();
      }
      if (options->reductions.empty()) {
        options->reductions = all_reductions();
      }
      return load_and_trade(*options);
    };
  });
}

}  // namespace impetus::inline commands
