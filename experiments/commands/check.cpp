// `impetus check`: validates protocols and prints their designs.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/expected_length.hpp"
#include "experiments/protocol/protocol_page.hpp"
#include "experiments/protocol/series_file.hpp"
#include "experiments/questions/rating.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus check` was asked for.
struct CheckOptions {
  std::vector<std::string> files;
  double refresh_hz{60.0};
  bool allow_rounding{false};
  bool explain{false};
};

void print_factors(const Protocol& protocol) {
  for (const Factor& factor : protocol.design.factors) {
    std::printf("  factor       %s = %s\n", factor.name.c_str(), level_list(factor).c_str());
    std::printf("               %s; overrides %s\n", factor.label.c_str(), factor.pointer.c_str());
  }
}

/// How often each level of each factor is shown in the main trials, catch trials apart; nobody
/// knows it of adaptive levels.
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
    if (protocol.design.adaptive && protocol.design.adaptive->factor == factor.name) {
      continue;
    }
    std::string text;
    for (const LevelValue& level : factor.levels) {
      const std::string value = to_text(level);
      text += (text.empty() ? "" : ", ") + value + ": " +
              std::to_string(shown[factor.name + " " + value]) + " times";
    }
    std::printf("  shown        %s %s\n", factor.name.c_str(), text.c_str());
  }
}

/// "click during the stimulus, rating after the stimulus"
std::string response_list(const Script& script) {
  std::string text;
  for (const auto& question : script.asked) {
    text += (text.empty() ? "" : ", ") + question->kind().name + " " + question->kind().when;
  }
  return script.gaze ? text + "; the gaze is followed" : text;
}

void print_design(const Protocol& protocol) {
  const Design& design = protocol.design;
  const Plan plan = plan_for(protocol, "P01", 1);
  std::printf("%s: valid\n", protocol.document.name.c_str());
  std::printf("  %s\n", protocol.title.c_str());
  std::printf("  scene        %s\n", protocol.scene.name.c_str());
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

void check_one(const std::filesystem::path& file, const CheckOptions& options) {
  const Protocol protocol = load_protocol(file);
  check_frames(protocol, options.refresh_hz, options.allow_rounding);
  if (options.explain) {
    std::printf("%s", protocol_page(protocol).c_str());
  } else {
    print_design(protocol);
  }
}

int check(const CheckOptions& options) {
  const BuildingLine told;
  int status = kDone;
  for (const std::string& file : options.files) {
    try {
      for (const std::filesystem::path& protocol : load_series(shipped_file(file)).protocols) {
        check_one(protocol, options);
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
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      app.add_subcommand("check", "Validate protocols, or series of them, and print their designs");
  command->add_option("files", options->files, "Files of protocols or series")->required();
  command
      ->add_option("--refresh", options->refresh_hz, "Frames per second of the display to be used")
      ->capture_default_str()
      ->check(CLI::Range(20.0, 1000.0));
  command->add_flag("--allow-rounding", options->allow_rounding,
                    "Accept delays that are not whole frames, as `run` would with this option");
  command->add_flag("--explain", options->explain,
                    "Print a page, in Markdown, that explains the study whole");
  command->callback([options, &chosen] { chosen = [options] { return check(*options); }; });
}

}  // namespace impetus::inline commands
