// `impetus predict`: what comes of each condition of a protocol whose scenes have a goal, what
// would come of it without the other body, and what a simulated participant expects.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/observers/imagining/counterfactual_observer.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What `impetus predict` was asked for.
struct PredictOptions {
  std::string protocol;
  std::string observer;
  std::int64_t runs{1000};
  std::uint64_t seed{1};
  std::string paths;
};

/// A condition whose scene differs from those before it.
struct Shown {
  Condition condition;
  StagedScene scene;
};

std::vector<Shown> shown_by(const Protocol& protocol) {
  const ProtocolScenes scenes(protocol, kUnroundedHold);
  std::vector<Condition> conditions = cells(protocol.design);
  conditions.insert(conditions.end(), protocol.design.practice.begin(),
                    protocol.design.practice.end());
  std::set<std::string> seen;
  std::vector<Shown> shown;
  for (const Condition& condition : conditions) {
    if (seen.insert(scene_under(protocol, condition).dump()).second) {
      shown.push_back({condition, scenes.stage(condition, assumed_screen())});
    }
  }
  return shown;
}

/// Its levels but those that are the same in all; practice has none of factors between
/// participants.
std::string words_of(const Condition& condition, const std::vector<Shown>& all) {
  std::string words;
  for (const FactorLevel& level : condition) {
    const bool varies = std::any_of(all.begin(), all.end(), [&](const Shown& other) {
      const FactorLevel* own = find_level(other.condition, level.factor);
      return own != nullptr && !(*own == level);
    });
    if (varies) {
      words += (words.empty() ? "" : ", ") + level.factor + " " + to_text(level.value);
    }
  }
  return words.empty() ? "all" : words;
}

std::string outcome(bool through) { return through ? "through" : "misses"; }

std::string percent(double share) { return printed("%.1f", 100.0 * share); }

/// Where every body is at every step, in pixels of the plane and in degrees: a row for each.
void write_path(const Protocol& protocol, const Shown& shown, const std::string& words,
                std::ofstream& file) {
  const Scene settings(scene_under(protocol, shown.condition));
  const double m_per_deg = metres_per_degree(assumed_screen().viewing_distance_m);
  SceneRun run(shown.scene);
  const auto write = [&] {
    for (std::size_t body = 0; body < run.world().states().size(); ++body) {
      if (run.world().models()[body].inverse_mass > 0.0) {
        const Vector3 deg = run.world().states()[body].pose.position / m_per_deg;
        const Vector3 px = settings.plane->px_per_deg * deg;
        const std::string numbers =
            printed("%.6f,%.4f,%.4f", static_cast<double>(run.number()) / shown.scene.step_hz,
                    px.x() + settings.plane->origin_px[0], px.y() + settings.plane->origin_px[1]);
        file << csv_text(words) << ',' << csv_text(run.world().models()[body].name) << ','
             << numbers << '\n';
      }
    }
  };
  write();
  while (static_cast<double>(run.number()) < run.ends_s() * shown.scene.step_hz) {
    run.step_whole();
    write();
  }
}

void write_paths(const Protocol& protocol, const std::vector<Shown>& all, const fs::path& path) {
  std::ofstream file(path);
  file << "condition,body,time_s,x_px,y_px\n";
  for (const Shown& shown : all) {
    write_path(protocol, shown, words_of(shown.condition, all), file);
  }
  file.flush();
  if (!file) {
    throw InputError(path.string() + ": expected a file that can be written");
  }
}

Imagination imagination_of(const Protocol& protocol, const fs::path& file,
                           const PredictOptions& options) {
  const std::string name = options.observer.empty() ? file.stem().string() : options.observer;
  const ObserverFile observer = observer_for(protocol, file, name);
  if (observer.kind->name != "counterfactual") {
    throw InputError(observer.document.name +
                     ": expected a simulated participant of the kind counterfactual, got " +
                     observer.kind->name);
  }
  Imagination by = static_cast<const CounterfactualParameters&>(*observer.parameters).imagination();
  by.in_pairs = true;
  by.runs = options.runs;
  return by;
}

int predict(const PredictOptions& options) {
  require_new_file(options.paths);
  const fs::path file = shipped_file(options.protocol);
  const Protocol protocol = load_protocol(file);
  if (!protocol.scene.value.contains("goal")) {
    refuse(protocol.scene, "/goal", "expected a goal, by which something may come of it");
  }
  const Imagination by = imagination_of(protocol, file, options);
  const std::vector<Shown> all = shown_by(protocol);
  if (!options.paths.empty()) {
    write_paths(protocol, all, options.paths);
  }
  std::vector<std::vector<std::string>> rows{{"condition", "what happens", "without",
                                              "what would have", "expected %",
                                              "made a difference %"}};
  auto progress = std::make_unique<ProgressLine>("imagining");
  for (const Shown& shown : all) {
    RandomStream draws(options.seed, "predict/" + to_json(shown.condition).dump());
    const Foresight foresight = foresee(shown.scene, by, draws);
    const std::string other =
        foresight.other ? shown.scene.world.models()[*foresight.other].name : "nobody";
    rows.push_back({words_of(shown.condition, all), outcome(foresight.through), other,
                    outcome(gets_through(shown.scene, foresight.other)), percent(foresight.without),
                    percent((foresight.through ? 1.0 : 0.0) - foresight.without)});
    progress->tell(static_cast<double>(rows.size() - 1) / static_cast<double>(all.size()));
  }
  progress.reset();
  std::printf(
      "%s\nexpected: of %lld imagined runs from the instant before the meeting on, without "
      "the other, heading turned by N(0, %g°) in each step of 1/%g s\n",
      text_table(rows).c_str(), static_cast<long long>(by.runs), by.heading_noise_deg, by.step_hz);
  return kDone;
}

}  // namespace

void add_predict(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<PredictOptions>(
      app, chosen, predict, "predict",
      "What comes of each condition, what would without the other body, and what is expected");
  command->add_option("protocol", options->protocol, "A protocol whose scenes have a goal")
      ->required();
  command->add_option("--observer", options->observer,
                      "A simulated participant of the kind counterfactual, its name or file; that "
                      "of the protocol's name when left out");
  command->add_option("--runs", options->runs, "Imagined runs for each condition")
      ->capture_default_str()
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1000000}));
  command->add_option("--seed", options->seed, "Of what is imagined")
      ->capture_default_str()
      ->check(CLI::Range(std::uint64_t{0}, kLargestSeed));
  command->add_option("--paths", options->paths,
                      "Writes where each body is at each step, in pixels of the plane (CSV)");
}

}  // namespace impetus::inline commands
