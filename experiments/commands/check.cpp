// `impetus check`: validates protocols and prints their designs; and scenes, with the least time
// that their steps take on this machine.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/languages/language_file.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/expected_length.hpp"
#include "experiments/protocol/protocol_page.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/protocol/series_file.hpp"
#include "experiments/questions/rating.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/step_floor.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus check` was asked for.
struct CheckOptions {
  std::vector<std::string> files;
  double refresh_hz{60.0};
  bool allow_rounding{false};
  bool explain{false};
  std::string observer;
};

void print_factors(const Protocol& protocol) {
  for (const Factor& factor : protocol.design.factors) {
    std::printf("  factor       %s = %s\n", factor.name.c_str(), level_list(factor).c_str());
    std::printf("               %s; %s%s\n", factor.label.c_str(),
                factor.keys_of.empty() ? "overrides " : "", changed_by(factor).c_str());
  }
}

/// How often each level of each factor is shown in the main trials, catch trials apart; nobody
/// knows it of adaptive levels, and one level is all that a participant has between participants.
void print_exposure(const Protocol& protocol, const Plan& plan) {
  std::map<std::string, std::int64_t> shown;
  for (const PlannedTrial& trial : plan) {
    if (trial.phase == TrialPhase::kMain && !trial.catch_trial) {
      for (const FactorLevel& level : trial.condition) {
        ++shown[level.factor + " " + to_text(level.value)];
      }
    }
  }
  for (const Factor& factor : protocol.design.factors) {
    if (factor.between ||
        (protocol.design.adaptive && protocol.design.adaptive->factor == factor.name)) {
      continue;
    }
    std::string text;
    for (const LevelValue& level : factor.levels) {
      const std::string value = to_text(level);
      text += (text.empty() ? "" : ", ") + value + ": " +
              std::to_string(shown[factor.name + " " + value]) +
              (shown[factor.name + " " + value] == 1 ? " time" : " times");
    }
    std::printf("  shown        %s %s\n", factor.name.c_str(), text.c_str());
  }
}

/// "click during the stimulus, rating after the stimulus"
std::string response_list(const Script& script) {
  const std::string text = listed(script.asked, [](const auto& question) {
    return question->kind().name + " " + question->kind().when;
  });
  return script.gaze ? text + "; the gaze is followed" : text;
}

void print_design(const Protocol& protocol) {
  const Design& design = protocol.design;
  const Plan plan = plan_for(protocol, "P01", 1);
  std::printf("%s: valid\n", protocol.document.name.c_str());
  std::printf("  %s\n", protocol.title.c_str());
  std::printf("  scene        %s\n", protocol.scene.name.c_str());
  if (const std::string& language = protocol.script.language.title();
      language != english().title()) {
    std::printf("  language     %s\n", language.c_str());
  }
  print_factors(protocol);
  const auto main_trials = std::count_if(plan.begin(), plan.end(), [](const PlannedTrial& trial) {
    return trial.phase == TrialPhase::kMain;
  });
  std::printf("  trials       %lld\n", static_cast<long long>(main_trials));
  for (const std::string& line : design_lines(design)) {
    std::printf("  design       %s\n", line.c_str());
  }
  print_exposure(protocol, plan);
  std::printf("  responses    %s\n", response_list(protocol.script).c_str());
  if (const RatingScale* scale = find_scale(protocol.script)) {
    std::printf("  rating       %lld (%s) to %lld (%s)\n", static_cast<long long>(scale->minimum),
                scale->low_anchor.c_str(), static_cast<long long>(scale->maximum),
                scale->high_anchor.c_str());
  }
  if (protocol.has_participants) {
    std::printf("  duration     about %.0f minutes, at %.1f s for an answer\n",
                std::ceil(expected_minutes(protocol, plan)), kAssumedAnswer_s);
  } else {
    std::printf("  participants none: every trial is simulated without a display\n");
  }
  std::printf("  hash         %s\n", protocol.hash.c_str());
}

const nlohmann::json::json_pointer kBudget_ms("/engine/budget/ms_per_step");

/// The floor of a scene whose budget is in milliseconds, on this machine, told in a line; none of
/// others. Refuses a budget that lies below it: `document` and `when` say whose it is.
std::optional<std::string> floor_line(const nlohmann::json& scene, const StagedScene& staged,
                                      const JsonDocument& document, const std::string& when) {
  if (!scene.contains(kBudget_ms)) {
    return std::nullopt;
  }
  const double budget_ms = scene[kBudget_ms].get<double>();
  const double floor = floor_ms(staged, ThreadClock());
  const std::string bodies = std::to_string(staged.looks.size()) + " bodies";
  if (floor > budget_ms) {
    refuse(document, kBudget_ms.to_string(),
           "expected at least " + two_digits(floor) + " ms, which a step of " + bodies +
               " takes on this machine whatever is left undone" + when + ", got " +
               csv_number(budget_ms));
  }
  return two_digits(floor) + " ms of a budget of " + csv_number(budget_ms) + " for " + bodies +
         ", on this machine";
}

/// The same of all scenes that a protocol shows, each said once.
void print_floors(const Protocol& protocol) {
  std::set<std::string> measured;
  for (const Condition& cell : cells(protocol.design)) {
    const nlohmann::json scene = scene_under(protocol, cell);
    if (!scene.contains(kBudget_ms) || !measured.insert(scene.dump()).second) {
      continue;
    }
    const std::string when = cell.empty() ? "" : " under " + to_json(cell).dump();
    const StagedScene staged = staged_from(protocol.scene, [&] {
      return build_scene(scene, assumed_screen(), kUnroundedHold, *protocol.shapes);
    });
    std::printf("  floor        %s%s\n", floor_line(scene, staged, protocol.scene, when)->c_str(),
                when.c_str());
  }
}

/// A scene by itself: what is in it, and its floor.
void check_scene(const std::filesystem::path& file, const CheckOptions& options) {
  const JsonDocument scene = load_scene(file);
  require_not_given({{options.explain, "--explain"}, {!options.observer.empty(), "--observer"}},
                    "expected a protocol, got a scene, " + scene.name);
  ShapeLibrary shapes;
  const StagedScene staged = staged_from(
      scene, [&] { return build_scene(scene.value, assumed_screen(), kUnroundedHold, shapes); });
  const std::optional<std::string> floor = floor_line(scene.value, staged, scene, "");
  std::printf("%s: valid, a scene\n  %s\n  bodies       %zu\n", scene.name.c_str(),
              scene.value["title"].get<std::string>().c_str(), staged.looks.size());
  std::printf("  floor        %s\n",
              floor
                  ? floor->c_str()
                  : (two_digits(floor_ms(staged, ThreadClock())) + " ms on this machine").c_str());
}

void check_one(const std::filesystem::path& file, const CheckOptions& options, SeriesNames& names) {
  if (is_scene(read_json(file))) {
    check_scene(file, options);
    return;
  }
  const Protocol protocol = load_protocol(file);
  names.take(protocol.name);
  check_frames(protocol, options.refresh_hz, options.allow_rounding);
  if (!options.observer.empty()) {
    tell_unseen_factors(protocol, observer_for(protocol, file, options.observer));
  }
  if (options.explain) {
    std::printf("%s", protocol_page(protocol).c_str());
  } else {
    print_design(protocol);
    print_floors(protocol);
  }
}

int check(const CheckOptions& options) {
  const BuildingLine told;
  int status = kDone;
  for (const std::string& file : options.files) {
    try {
      SeriesNames names(file);
      for (const std::filesystem::path& protocol : load_series(shipped_file(file)).protocols) {
        check_one(protocol, options, names);
      }
    } catch (const std::runtime_error& error) {
      std::fflush(stdout);
      std::fprintf(stderr, "impetus: %s\n", error.what());
      status = kFound;
    }
  }
  return status;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<CheckOptions>(
      app, chosen, check, "check",
      "Validate protocols, series of them, or scenes, and print what is in them");
  command->add_option("files", options->files, "Files of protocols, series or scenes")->required();
  command
      ->add_option("--refresh", options->refresh_hz, "Frames per second of the display to be used")
      ->capture_default_str()
      ->check(number_from(20.0, 1000.0));
  command->add_flag("--allow-rounding", options->allow_rounding,
                    "Accept delays that are not whole frames, as `run` would with this option");
  command->add_flag("--explain", options->explain,
                    "Print a page, in Markdown, that explains the study whole");
  command->add_option("--observer", options->observer,
                      "A simulated participant, its name or file, who is to fit the protocol");
}

}  // namespace impetus::inline commands
